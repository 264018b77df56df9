#include "render/spline_taps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutaway {

namespace {

/// Of what a texel's mean and the spline between texels smooth already, voxels squared.
double spline_variance(int factor) { return (factor * factor - 1) / 12.0 + factor * factor / 3.0; }

/// A copy that is almost as smooth as what is asked for is kinked between its own texels.
constexpr double kLeastOfOwn = 1.15;

/// The coarsest copy that leaves something to the taps.
std::size_t spline_level(double scale_mm, const VolumeGeometry& geometry,
                         const std::vector<glm::ivec3>& factors) {
  std::size_t level = 0;
  for (std::size_t next = 1; next < factors.size(); ++next) {
    bool fits = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double own_mm =
          std::sqrt(spline_variance(factors[next][axis])) * geometry.spacing_mm[axis];
      fits = fits && (factors[next][axis] == 1 || kLeastOfOwn * own_mm <= scale_mm);
    }
    if (fits) level = next;
  }
  return level;
}

/// Standard deviations along the axes that are left for the taps, voxels.
glm::dvec3 left_for_spline_taps(double scale_mm, const VolumeGeometry& geometry,
                                glm::ivec3 factor) {
  glm::dvec3 left;
  for (int axis = 0; axis < 3; ++axis) {
    const double wanted = scale_mm / geometry.spacing_mm[axis];
    left[axis] = std::sqrt(std::max(wanted * wanted - spline_variance(factor[axis]), 0.0));
  }
  return left;
}

/// Of a sphere of radius 1, in directions that weigh the same to the fifth degree.
std::vector<SplineTap> sphere() {
  std::vector<SplineTap> taps;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 offset(0.0);
      offset[axis] = side;
      taps.push_back({offset, 1.0 / 15.0});
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    taps.push_back({glm::dvec3(2 * side - 1) / std::numbers::sqrt3, 3.0 / 40.0});
  }
  return taps;
}

}  // namespace

SplineTaps spline_taps(double scale_mm, const VolumeGeometry& geometry,
                       const std::vector<glm::ivec3>& factors) {
  if (scale_mm <= 0.0) return {.level = 0, .taps = {{glm::dvec3(0.0), 1.0}}};
  SplineTaps taps{.level = spline_level(scale_mm, geometry, factors), .taps = sphere()};
  const glm::dvec3 left = left_for_spline_taps(scale_mm, geometry, factors.at(taps.level));
  for (SplineTap& tap : taps.taps) tap.offset_voxels *= std::numbers::sqrt3 * left;
  return taps;
}

}  // namespace cutaway
