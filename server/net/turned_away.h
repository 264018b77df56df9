// Addresses that were turned away where there is no queue to wait in, and will try again.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

namespace cutaway {

/// As good as waiting, for as long as they come back now and then. Not thread-safe.
class TurnedAway {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  void add(const std::string& group, TimePoint now);
  void remove(const std::string& group) { waits_.erase(group); }
  /// Leaves out who has not come back for longer than a page pauses between two attempts.
  void forget_the_gone(TimePoint now);
  /// Since when it has tried; nothing where it was not turned away.
  std::optional<TimePoint> since(const std::string& group) const;

  struct Wait {
    TimePoint since;
    TimePoint last;
  };
  const std::map<std::string, Wait>& all() const { return waits_; }

 private:
  std::map<std::string, Wait> waits_;  ///< by group
};

}  // namespace cutaway
