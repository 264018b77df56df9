// What is left to do for a frame: its passes in order, drawn strip by strip, so that a large frame
// holds up no small one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gl/framebuffer.h"

namespace cutaway {

/// Draws into a region of its target. What its functions refer to must outlive the plan.
struct Pass {
  std::string name;
  gl::PixelRect region;
  int cost = 1;  ///< of a pixel, in units of a simple pass' pixel
  /// Before the first strip; clears what lies outside of the region. May be empty.
  std::function<void()> begin;
  /// Draws a strip of the region. Sets all the state that it needs: other frames are drawn between
  /// two strips.
  std::function<void(const gl::PixelRect& strip)> draw;
  std::function<void()> done;  ///< the output is complete; may be empty
};

/// Called after each pass that was drawn, with its name; measuring only.
using PassObserver = std::function<void(const std::string& name)>;

/// Render thread only. A plan that is given up leaves stages without an output, which the next
/// frame's plan draws again.
class FramePlan {
 public:
  FramePlan() = default;
  explicit FramePlan(PassObserver observer) : observer_(std::move(observer)) {}

  void add(Pass pass) { passes_.push_back(std::move(pass)); }

  /// Whether a pass of that name is part of it.
  bool has(std::string_view name) const {
    return std::ranges::find(passes_, name, &Pass::name) != passes_.end();
  }

  bool is_done() const { return current_ == passes_.size(); }
  /// Draws for about `cost` units. Returns what it has drawn, in units.
  std::int64_t advance(std::int64_t cost);
  void finish();

 private:
  std::int64_t draw_strip(std::int64_t cost);

  PassObserver observer_;
  std::vector<Pass> passes_;
  std::size_t current_ = 0;
  int next_row_ = 0;  ///< of the current pass, from the begin of its region
};

}  // namespace cutaway
