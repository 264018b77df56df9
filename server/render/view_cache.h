// What is kept for views between their frames, within a limit.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>

#include "render/frame_pipeline.h"

namespace cutaway {

/// Render thread only. Buffers can always be drawn again: those of views that have not been drawn
/// for longest go first where all of them are more than the limit, and those of idle views after a
/// while.
class ViewCache {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ViewCache(std::uint64_t bytes) : bytes_(bytes) {}

  /// The view's state, which stays until unpin.
  ViewState& pin(std::uint64_t view);
  ViewState& pinned(std::uint64_t view) { return views_.at(view).state; }
  void unpin(std::uint64_t view);
  /// Forgets the view, at once or when it is unpinned.
  void drop(std::uint64_t view);

  /// To be called when buffers have grown.
  void keep_within_limit();
  void drop_idle(Clock::duration age);

  std::uint64_t used_bytes() const;

  /// Whether the pinned views leave room for another: what is pinned cannot go, so that they alone
  /// could be more than the limit.
  bool has_room() const;

 private:
  struct Entry {
    ViewState state;
    Clock::time_point used;
    bool pinned = false;
    bool dropped = false;
  };

  std::uint64_t bytes_;
  std::map<std::uint64_t, Entry> views_;
};

}  // namespace cutaway
