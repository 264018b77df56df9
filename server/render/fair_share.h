// Whose turn it is on the device.
#pragma once

#include <cstdint>
#include <map>
#include <span>

namespace cutaway {

/// The one that has had least of the device is next. So a session gets as much of the device with
/// large pictures as another with small ones. A session that was away does not catch up on what it
/// did not use. Not thread-safe.
class FairShare {
 public:
  /// Of those that wait (in the order in which they began to), the one to serve. `waiting` is
  /// not empty.
  std::uint64_t next(std::span<const std::uint64_t> waiting);
  /// `who` was served at this cost.
  void charge(std::uint64_t who, std::int64_t cost) { used_[who] += cost; }
  void forget(std::uint64_t who) { used_.erase(who); }
  bool knows_nobody() const { return used_.empty(); }

 private:
  std::map<std::uint64_t, std::int64_t> used_;
  std::int64_t least_ = 0;  ///< what who was served last had had before
};

}  // namespace cutaway
