// What is measured: the control, the dissertation's configurations (its table 5.3), the flagship,
// and each lens, filter, part of light and translucent material alone.
#pragma once

#include <string>
#include <vector>

#include "scene/json.h"

namespace cutaway::benchmark {

struct FrameCase {
  std::string name;
  Json scene;  ///< partial scene document; the volume and the camera are chosen by the benchmark

  bool has_no_lens() const { return scene["lens"]["mode"] == "none"; }
};

/// The first five differ from each other by the parts of the dissertation's style. Those whose name
/// ends in "alone" are the control, which is the first, and one thing more: each lens shape in each
/// mode, each filter of the registry over the whole picture, at its defaults, and the like.
std::vector<FrameCase> frame_cases();

/// The style as it is.
FrameCase flagship_case();

}  // namespace cutaway::benchmark
