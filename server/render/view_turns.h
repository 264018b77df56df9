// Which view's turn it is on the device.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "render/fair_share.h"

namespace cutaway {

/// A view that wants the device, and the share that it counts to.
struct ShareOfView {
  std::uint64_t view;
  std::uint64_t share;
};

/// First the share, then the view: who has four pictures gets no more than who has one, and what
/// others get of the device says nothing about the turns of one's own pictures. Not thread-safe.
class ViewTurns {
 public:
  /// Of those that wait (in the order in which they began to), the view to serve. `waiting` is not
  /// empty.
  std::uint64_t next(std::span<const ShareOfView> waiting);
  /// `who` was served at this cost.
  void charge(const ShareOfView& who, std::int64_t cost);
  /// With the last of its views a share is forgotten.
  void forget(std::uint64_t view);

 private:
  FairShare shares_;
  std::map<std::uint64_t, FairShare> views_;  ///< of each share
};

}  // namespace cutaway
