// From a segment of a script to the messages that a client sends.
#pragma once

#include <vector>

#include "load/camera_path.h"
#include "load/script.h"

namespace cutaway::load {

/// One message, without `input` and `clock_ms`, and when it is due.
struct Step {
  double at_s = 0.0;
  Json message;
};

/// What a motion is made for.
struct Stage {
  const CameraPath& camera;
  PictureSize viewport;
  double inputs_per_second;
};

/// The segment's steps, `at_s` from its start. `pose` is where the camera is at its start, and
/// afterwards where it is at its end; only an orbit leaves it elsewhere.
std::vector<Step> steps_of(const Segment& segment, const Stage& stage, Pose& pose);

}  // namespace cutaway::load
