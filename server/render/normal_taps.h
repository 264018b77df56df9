// Where a Gaussian's gradient is sampled: pairs of taps around a point.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"
#include "volume/geometry.h"

namespace cutaway {

/// One of two taps that lie opposite each other.
struct TapPair {
  glm::dvec3 offset_voxels;  ///< from the point
  /// Patient space, per mm: what a rise of two from the one tap to the other adds to the gradient.
  glm::dvec3 gradient;
};

inline constexpr std::size_t kTapPairs = 13;

struct NormalTaps {
  std::size_t level = 0;  ///< of the volume's copies; 0: itself
  std::vector<TapPair> pairs;
};

/// Standard deviation of the Gaussian that a branch's normals are asked for with, mm; 0: none.
double normal_scale_mm(const Normals& normals, bool is_focus, const VolumeGeometry& geometry);

/// Exact for what rises linearly. `factors`: the voxels that a texel of each copy spans, along each
/// axis, from the volume's own (1, 1, 1) on.
NormalTaps normal_taps(double scale_mm, const VolumeGeometry& geometry,
                       const std::vector<glm::ivec3>& factors);

}  // namespace cutaway
