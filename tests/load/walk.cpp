#include "load/walk.h"

#include <algorithm>

namespace cutaway::load {

namespace {

double loop_s(const Role& role) {
  double length = 0.0;
  for (const Segment& segment : role.motion)
    length += segment.for_s + 0.5 * (segment.think_s[0] + segment.think_s[1]);
  return length;
}

}  // namespace

Walk::Walk(const Role& role, CameraPath camera, std::uint32_t seed, double entry)
    : role_(role), camera_(std::move(camera)), random_(seed), time_s_(-entry * loop_s(role)) {}

std::optional<Step> Walk::next() {
  while (fill()) {
    Step step = std::move(steps_.front());
    steps_.pop_front();
    if (step.at_s >= 0.0) return step;  // what lies before the entry only turns the camera
  }
  return std::nullopt;
}

double Walk::pause_s() const { return std::max(0.3, 2.5 / role_.inputs_per_second); }

// False where a whole loop has no step.
bool Walk::fill() {
  for (std::size_t i = 0; i < role_.motion.size() && steps_.empty(); ++i) take_segment();
  return !steps_.empty();
}

void Walk::take_segment() {
  const Segment& segment = role_.motion[segment_];
  const Stage stage{camera_, role_.viewport, role_.inputs_per_second};
  for (Step& step : steps_of(segment, stage, pose_)) {
    step.at_s += time_s_;
    steps_.push_back(std::move(step));
  }
  time_s_ += segment.for_s + think_s(segment);
  segment_ = (segment_ + 1) % role_.motion.size();
}

double Walk::think_s(const Segment& segment) {
  return std::uniform_real_distribution<double>(segment.think_s[0], segment.think_s[1])(random_);
}

}  // namespace cutaway::load
