// One ray through a volume on the CPU: for picking and for choosing where a lens starts.
#pragma once

#include <optional>

#include "core/value_band.h"
#include "volume/volume.h"

namespace cutaway {

struct PatientRay {
  glm::dvec3 origin_mm{0.0};
  glm::dvec3 direction{0.0, 0.0, 1.0};  ///< unit length
};

struct RayInterval {
  double begin_mm = 0.0;
  double end_mm = 0.0;
};

/// Where the ray is inside the box of voxel centres, clipped to distances >= 0; nothing where it
/// misses.
std::optional<RayInterval> intersect_grid(const VolumeGeometry& geometry, const PatientRay& ray);

/// Distance along the ray to the first point within `limits` where the value enters the band,
/// marching half the smallest spacing and refining by bisection; the start itself counts where it
/// lies in the band already. A band that is jumped over between two samples is met where its first
/// limit is crossed.
std::optional<double> first_surface_mm(const Volume& volume, const PatientRay& ray,
                                       const ValueBand& band, RayInterval limits);

}  // namespace cutaway
