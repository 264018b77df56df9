// The filters again, in double and without a thought for speed: what the GPU's are compared with.
#pragma once

#include "scene/scene.h"
#include "support/reference_image.h"

namespace cutaway::reference {

BranchImage kuwahara(const BranchImage& input, int radius_px);

struct Sobel {
  double strength = 0.7;
  std::string mode = "darken";    ///< darken, brighten, multiply
  std::string source = "colour";  ///< colour, luma, depth, normal
  bool silhouettes = true;
  double depth_step_mm = 100.0;
  bool unit_norm = false;
  bool euclidean = false;
};
BranchImage sobel(const BranchImage& input, const Sobel& parameters);

/// Any filter of the scene's registry by its name.
BranchImage apply_filter(const BranchImage& input, const Module& filter, double resolution_scale);

}  // namespace cutaway::reference
