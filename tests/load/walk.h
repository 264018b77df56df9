// A client's way through its role's motions.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>

#include "load/motion.h"

namespace cutaway::load {

/// The role's segments in a loop without end, as one sequence of steps whose `at_s` counts from the
/// walk's start. The same seed gives the same walk.
class Walk {
 public:
  /// `entry` in 0..1 says where in the loop the walk begins.
  Walk(const Role& role, CameraPath camera, std::uint32_t seed, double entry);

  /// Nothing where the role never sends anything.
  std::optional<Step> next();

  /// A step that comes later than this after the one before begins another movement, s.
  double pause_s() const;

 private:
  bool fill();
  void take_segment();
  double think_s(const Segment& segment);

  const Role& role_;
  CameraPath camera_;
  std::mt19937 random_;
  Pose pose_;
  std::deque<Step> steps_;
  std::size_t segment_ = 0;
  double time_s_ = 0.0;  ///< where the next segment begins
};

}  // namespace cutaway::load
