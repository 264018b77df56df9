// Where the slope of a volume's cubic B-spline is averaged, for normals at a scale.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "volume/geometry.h"

namespace cutaway {

struct SplineTap {
  glm::dvec3 offset_voxels;  ///< from the point
  double weight;             ///< of all: 1
};

/// Around a point, where a scale is asked for.
inline constexpr std::size_t kScaledTaps = 14;

struct SplineTaps {
  std::size_t level = 0;  ///< of the volume's copies; 0: itself
  std::vector<SplineTap> taps;
};

/// `scale_mm`: standard deviation of the Gaussian, of which a copy's means and the spline are most;
/// 0: the spline's own. `factors`: the voxels that a texel of each copy spans, along each axis,
/// from the volume's own (1, 1, 1) on.
SplineTaps spline_taps(double scale_mm, const VolumeGeometry& geometry,
                       const std::vector<glm::ivec3>& factors);

}  // namespace cutaway
