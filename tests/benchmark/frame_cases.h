// What is measured: the dissertation's five configurations (techniques: its table 5.3).
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

/// All share the flagship's surfaces, light and background, so that they differ in one thing each.
std::vector<FrameCase> frame_cases();

}  // namespace cutaway::benchmark
