#include "render/normal_taps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutaway {

namespace {

/// In voxels of the plane, for the context: calm enough that 3 mm CT has no grain.
constexpr double kCalmVoxels = 2.5;
/// In the largest spacing, against terraces; and no more than the coarsest copy can serve.
constexpr double kCalmSlices = 1.5;
constexpr double kWidestVoxels = 12.0;
constexpr double kFocusShare = 0.5;

/// Along an axis the Gaussian is at least so many voxels wide, or its samples would not form one.
constexpr double kLeastVoxels = 0.8;

/// A copy serves a Gaussian from so many of its texels on. With fewer the kinks between texels show
/// as grain on smooth skin.
constexpr double kLeastTexels = 0.75;

/// Directions in a shell around the point, one of each pair, and its radius in standard deviations.
struct Shell {
  std::vector<glm::dvec3> directions;
  double radius;
};

/// A cube's faces and corners within its edges: of the sets of up to 32 taps that were tried the
/// one that is near the truth on every copy, without noise and with it.
std::vector<Shell> shells() {
  Shell inner{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1.55};
  Shell outer{{}, 2.25};
  for (const double y : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0})
      inner.directions.push_back(glm::dvec3(1.0, y, z) / std::numbers::sqrt3);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 edge(0.0);
      edge[axis] = 1.0;
      edge[(axis + 1) % 3] = y;
      outer.directions.push_back(edge / std::numbers::sqrt2);
    }
  }
  return {inner, outer};
}

/// Of what a texel and the interpolation between texels smooth already, voxels squared.
double own_variance(int factor) { return (factor * factor - 1) / 12.0 + factor * factor / 6.0; }

/// Standard deviations along the axes that are left for the taps, voxels.
glm::dvec3 left_for_taps(double scale_mm, const VolumeGeometry& geometry, glm::ivec3 factor) {
  glm::dvec3 left;
  for (int axis = 0; axis < 3; ++axis) {
    const double wanted = std::max(scale_mm / geometry.spacing_mm[axis], kLeastVoxels);
    const double half_texel = std::max(0.5 * factor[axis], 0.5);
    left[axis] = std::sqrt(
        std::max(wanted * wanted - own_variance(factor[axis]), 0.09 * half_texel * half_texel));
  }
  return left;
}

std::size_t level_for(double scale_mm, const VolumeGeometry& geometry,
                      const std::vector<glm::ivec3>& factors) {
  std::size_t level = 0;
  for (std::size_t next = 1; next < factors.size(); ++next) {
    const glm::dvec3 texel_mm = glm::dvec3(factors[next]) * geometry.spacing_mm;
    if (scale_mm >= kLeastTexels * std::max({texel_mm.x, texel_mm.y, texel_mm.z})) level = next;
  }
  return level;
}

/// A shell's share of the gradient, by the Gaussian's weight of its radius.
double weight_of(const Shell& shell) {
  const double squared = shell.radius * shell.radius;
  return squared * std::exp(-squared / 2.0) * static_cast<double>(shell.directions.size()) / 3.0;
}

}  // namespace

double normal_scale_mm(const Normals& normals, bool is_focus, const VolumeGeometry& geometry) {
  if (normals.scale == NormalScale::fixed) return normals.scale_mm;
  const glm::dvec3 spacing_mm = geometry.spacing_mm;
  const double calm_mm =
      std::max(kCalmVoxels * std::max(spacing_mm.x, spacing_mm.y),
               kCalmSlices * std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z}));
  return std::min(is_focus ? kFocusShare * calm_mm : calm_mm,
                  kWidestVoxels * smallest_spacing_mm(geometry));
}

NormalTaps normal_taps(double scale_mm, const VolumeGeometry& geometry,
                       const std::vector<glm::ivec3>& factors) {
  NormalTaps taps{.level = level_for(scale_mm, geometry, factors), .pairs = {}};
  const glm::dvec3 left = left_for_taps(scale_mm, geometry, factors.at(taps.level));
  double all = 0.0;
  for (const Shell& shell : shells()) all += weight_of(shell);
  for (const Shell& shell : shells()) {
    const double share = shell.radius * shell.radius * std::exp(-shell.radius * shell.radius / 2.0);
    const glm::dvec3 reach = shell.radius * left;
    for (const glm::dvec3& direction : shell.directions)
      taps.pairs.push_back(
          {reach * direction,
           geometry.direction_patient * (share / all * direction / (reach * geometry.spacing_mm))});
  }
  return taps;
}

}  // namespace cutaway
