// The filters again, in double and without a thought for speed: what the GPU's are compared with.
#pragma once

#include "scene/scene.h"
#include "support/reference_image.h"

namespace cutaway::reference {

BranchImage kuwahara(const BranchImage& input, int radius_px);

BranchImage anisotropic_kuwahara(const BranchImage& input, double radius_px, double anisotropy,
                                 double sharpness);

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

struct DepthLines {
  double strength = 1.0;
  double width_px = 2.0;
  glm::dvec3 ink{0.0};
  double thinnest = 0.55;  ///< width at the smallest gap, as a share
  double gap_mm = 2.0;
  double full_gap_mm = 20.0;
  bool silhouettes = true;
};
BranchImage depth_lines(const BranchImage& input, const DepthLines& lines);

/// Any filter of the scene's registry by its name.
BranchImage apply_filter(const BranchImage& input, const Module& filter, double resolution_scale);

}  // namespace cutaway::reference
