// Chooses one of a few steps of quality so that a measured cost stays within a budget, without
// swinging.
#pragma once

#include <vector>

#include "session/strand.h"

namespace cutaway {

/// Step 0 is the best and dearest. Falls at once to the step that should fit when the smoothed cost
/// leaves the budget; climbs one step after several frames whose cost, scaled to that step, leaves
/// room. Costs that do not scale as `relative_cost` says would keep it low for ever, so from time
/// to time it also tries the next step, ever more seldom where that fails.
class StepControl {
 public:
  struct Step {
    double value;
    double relative_cost;  ///< of step 0's
  };

  /// Begins at the best step whose value is `first` at most, or at the last.
  StepControl(std::vector<Step> steps, Milliseconds budget, double first);

  double value() const { return steps_[current_].value; }
  bool at_last() const { return current_ + 1 == steps_.size(); }

  /// Cost of something made at the present step.
  void observe(Milliseconds cost);

 private:
  bool over_budget() const;
  bool room_above() const;
  void fall();
  void consider_climbing();
  void move_to(std::size_t step);

  std::vector<Step> steps_;
  Milliseconds budget_;
  std::size_t current_ = 0;
  Milliseconds smoothed_{0.0};
  int observed_ = 0;      ///< at this step
  int roomy_frames_ = 0;  ///< in a row, with room for the next step up
  int calm_frames_ = 0;   ///< in a row, within the budget
  int frames_to_try_ = 30;
  bool trying_ = false;
};

}  // namespace cutaway
