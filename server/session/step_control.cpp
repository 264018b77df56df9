#include "session/step_control.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace cutaway {

namespace {

constexpr double kSmoothing = 0.3;  // weight of the newest cost
constexpr double kOver = 1.15;      // of the budget: falls
constexpr double kRoom = 0.8;       // of the budget: may climb
constexpr int kRoomyFrames = 4;     // in a row before climbing
constexpr int kFramesToTry = 30;    // within the budget before trying the next step unasked
constexpr int kFramesToTryMost = 960;

}  // namespace

StepControl::StepControl(std::vector<Step> steps, Milliseconds budget, double first)
    : steps_(std::move(steps)), budget_(budget), frames_to_try_(kFramesToTry) {
  check(!steps_.empty(), "a step to choose");
  while (!at_last() && steps_[current_].value > first) ++current_;
}

void StepControl::observe(Milliseconds cost) {
  smoothed_ = observed_ == 0 ? cost : (smoothed_ * (1.0 - kSmoothing)) + (cost * kSmoothing);
  ++observed_;
  if (over_budget()) {
    fall();
  } else {
    consider_climbing();
  }
}

// One dear frame after a change of step may be chance; two, or one far off, are not.
bool StepControl::over_budget() const {
  if (observed_ == 1) return smoothed_ > budget_ * 2.0;
  return smoothed_ > budget_ * kOver;
}

bool StepControl::room_above() const {
  const double ratio = steps_[current_ - 1].relative_cost / steps_[current_].relative_cost;
  return smoothed_ * ratio < budget_ * kRoom;
}

void StepControl::fall() {
  if (trying_) frames_to_try_ = std::min(frames_to_try_ * 2, kFramesToTryMost);
  const Milliseconds unit = smoothed_ / steps_[current_].relative_cost;
  std::size_t step = current_;
  while (step + 1 < steps_.size() && unit * steps_[step].relative_cost > budget_) ++step;
  move_to(step);
}

void StepControl::consider_climbing() {
  if (current_ == 0) return;
  ++calm_frames_;
  roomy_frames_ = room_above() ? roomy_frames_ + 1 : 0;
  const bool roomy = roomy_frames_ >= kRoomyFrames;
  const bool worth_a_try = calm_frames_ >= frames_to_try_ && smoothed_ < budget_ * kRoom;
  if (!roomy && !worth_a_try) return;
  move_to(current_ - 1);
  trying_ = !roomy;
}

void StepControl::move_to(std::size_t step) {
  if (step != current_) {
    observed_ = 0;
    smoothed_ = Milliseconds(0.0);
  }
  current_ = step;
  roomy_frames_ = 0;
  calm_frames_ = 0;
  trying_ = false;
}

}  // namespace cutaway
