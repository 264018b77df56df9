// What each branch adds to one ray, front to back with one transmittance.
#pragma once

#include "support/reference_ray.h"

namespace cutaway::reference {

/// One branch on one ray.
struct BranchLayers {
  glm::dvec3 colour{0.0};  ///< premultiplied
  double opacity = 0.0;
  bool is_met = false;          ///< whether the ray meets the branch at all
  SurfaceHit nearest;           ///< its first layer, where it is met
  bool is_behind_lens = false;  ///< that one, for the context
  bool within_outline = false;  ///< met, or taken from it by the lens
};

struct RayLayers {
  BranchLayers context;
  BranchLayers focus;
};

RayLayers trace(const Scene& scene, const Volume& volume, const ViewRay& ray, double step_mm,
                int picture_height_px);

}  // namespace cutaway::reference
