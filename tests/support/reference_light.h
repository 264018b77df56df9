// How much light comes to a surface, for the reference renderer: each ray marched in turn.
#pragma once

#include "scene/scene.h"
#include "support/reference_copy.h"
#include "support/reference_image.h"
#include "support/reference_layers.h"

namespace cutaway::reference {

/// Rays from each point, and samples along each.
struct LightRays {
  int directions = 16;
  int samples = 16;
  int shadow_rays = 4;
  int shadow_samples = 24;
  /// Turned from pixel to pixel in a pattern of 4 x 4, which is then smoothed away.
  bool has_pattern = true;
};

/// Ambient light and the light itself, 1 where nothing keeps it away. A pixel's first ray that
/// meets the branch speaks for it.
Image<glm::dvec2> light_reach(const Scene& scene, const Volume& volume, const ReferenceCopy& copy,
                              const Image<RayLayers>& rays, BranchName branch, int supersampling,
                              const LightRays& light);

}  // namespace cutaway::reference
