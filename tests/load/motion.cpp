#include "load/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutaway::load {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Calls `step` with the time of each input of the segment.
template <typename Function>
void each_input(double for_s, double per_second, const Function& step) {
  const auto count = static_cast<long>(std::floor(for_s * per_second + 1e-9));
  for (long i = 1; i <= count; ++i) step(static_cast<double>(i) / per_second);
}

class Steps {
 public:
  Steps(const Segment& segment, const Stage& stage, Pose& pose)
      : segment_(segment), stage_(stage), pose_(pose) {}

  std::vector<Step> operator()(const Orbit& orbit) const {
    const double start = pose_.azimuth_degrees;
    const auto azimuth = [&](double t) {
      return std::fmod(start + orbit.degrees_per_second * t, 360.0);
    };
    std::vector<Step> steps = along([&](double t) { return Pose{.azimuth_degrees = azimuth(t)}; });
    pose_ = {.azimuth_degrees = azimuth(segment_.for_s)};
    return steps;
  }

  // A lying figure of eight, so that both angles move.
  std::vector<Step> operator()(const Inspect& inspect) const {
    const double period = inspect.move_s + inspect.pause_s;
    std::vector<Step> steps;
    each_input(segment_.for_s, stage_.inputs_per_second, [&](double t) {
      const double within = std::fmod(t, period);
      if (within > inspect.move_s) return;
      const double phase = kTurn * within / inspect.move_s;
      Pose swung = pose_;
      swung.azimuth_degrees += inspect.swing_degrees * std::sin(phase);
      swung.elevation_degrees += 0.5 * inspect.swing_degrees * std::sin(2.0 * phase);
      steps.push_back({t, stage_.camera.message(swung)});
    });
    return steps;
  }

  std::vector<Step> operator()(const DragLens& drag) const {
    const double width = stage_.viewport.width_px;
    const double height = stage_.viewport.height_px;
    const double radius_px = drag.radius * std::min(width, height);
    std::vector<Step> steps;
    each_input(segment_.for_s, stage_.inputs_per_second, [&](double t) {
      const double angle = kTurn * drag.turns_per_second * t;
      const double x_px = drag.centre[0] * width + radius_px * std::cos(angle);
      const double y_px = drag.centre[1] * height + radius_px * std::sin(angle);
      steps.push_back({t, {{"type", "drag_lens"}, {"position_px", {x_px, y_px}}}});
    });
    return steps;
  }

  std::vector<Step> operator()(const Zoom& zoom) const {
    return along([&](double t) {
      Pose nearer = pose_;
      const double share = 0.5 * (1.0 - std::cos(kTurn * t / zoom.period_s));
      nearer.distance = std::pow(zoom.nearest, share);
      return nearer;
    });
  }

  std::vector<Step> operator()(const Idle&) const { return {}; }

  std::vector<Step> operator()(const Recorded& recorded) const {
    // A gap as between two inputs, so that a recording of one message repeats at all.
    const double length = recorded.messages.back().at_s + 1.0 / stage_.inputs_per_second;
    std::vector<Step> steps;
    for (double begin = 0.0; begin < segment_.for_s; begin += length) {
      for (const RecordedMessage& entry : recorded.messages) {
        if (begin + entry.at_s < segment_.for_s)
          steps.push_back({begin + entry.at_s, entry.message});
      }
    }
    return steps;
  }

 private:
  template <typename PoseAt>
  std::vector<Step> along(const PoseAt& pose_at) const {
    std::vector<Step> steps;
    each_input(segment_.for_s, stage_.inputs_per_second, [&](double t) {
      steps.push_back({t, stage_.camera.message(pose_at(t))});
    });
    return steps;
  }

  const Segment& segment_;
  const Stage& stage_;
  Pose& pose_;
};

}  // namespace

std::vector<Step> steps_of(const Segment& segment, const Stage& stage, Pose& pose) {
  return std::visit(Steps(segment, stage, pose), segment.motion);
}

}  // namespace cutaway::load
