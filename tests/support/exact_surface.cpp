#include "support/exact_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "volume/ray_probe.h"

namespace cutaway::reference {

namespace {

/// Distances at which the ray passes from one cell into the next, with both ends of the grid.
std::vector<double> cell_borders_mm(const VolumeGeometry& geometry, const ViewRay& ray,
                                    const RayInterval& inside) {
  const glm::dmat4 to_index = patient_to_index(geometry);
  const glm::dvec3 origin(to_index * glm::dvec4(ray.origin_mm, 1.0));
  const glm::dvec3 direction(to_index * glm::dvec4(ray.direction, 0.0));
  std::vector<double> borders{inside.begin_mm, inside.end_mm};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    for (int plane = 1; plane < geometry.size_voxels[axis] - 1; ++plane) {
      const double at_mm = (plane - origin[axis]) / direction[axis];
      if (at_mm > inside.begin_mm && at_mm < inside.end_mm) borders.push_back(at_mm);
    }
  }
  std::ranges::sort(borders);
  return borders;
}

/// Coefficients c[0] + c[1] t + c[2] t^2 + c[3] t^3 through the values at t = 0, 1/3, 2/3, 1.
std::array<double, 4> cubic_through(const std::array<double, 4>& v) {
  const double d1 = v[1] - v[0];
  const double d2 = v[2] - 2.0 * v[1] + v[0];
  const double d3 = v[3] - 3.0 * v[2] + 3.0 * v[1] - v[0];
  return {v[0], 3.0 * d1 - 1.5 * d2 + d3, 4.5 * d2 - 4.5 * d3, 4.5 * d3};
}

/// Where the cubic turns within 0..1, between both ends: it is monotone from each to the next.
std::vector<double> monotone_pieces(const std::array<double, 4>& c) {
  std::vector<double> ends{0.0, 1.0};
  const double a = 3.0 * c[3];
  const double b = 2.0 * c[2];
  const double discriminant = b * b - 4.0 * a * c[1];
  if (discriminant > 0.0) {
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    for (const double turn : {q / a, c[1] / q}) {
      if (turn > 0.0 && turn < 1.0) ends.push_back(turn);
    }
  }
  std::ranges::sort(ends);
  return ends;
}

std::optional<double> first_root(const std::array<double, 4>& c) {
  const auto value = [&](double t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
  const std::vector<double> ends = monotone_pieces(c);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    double low = ends[i];
    double high = ends[i + 1];
    if (value(high) <= 0.0) continue;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (value(middle) > 0.0 ? high : low) = middle;
    }
    return high;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> first_crossing_mm(const Volume& volume, const ViewRay& ray,
                                        double iso_value) {
  const auto inside = intersect_grid(volume.geometry, {ray.origin_mm, ray.direction});
  if (!inside) return std::nullopt;
  const glm::dmat4 to_index = patient_to_index(volume.geometry);
  const auto height = [&](double distance_mm) {
    const glm::dvec4 position(ray.origin_mm + distance_mm * ray.direction, 1.0);
    return sample(volume, glm::dvec3(to_index * position)) - iso_value;
  };
  const std::vector<double> borders = cell_borders_mm(volume.geometry, ray, *inside);
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    std::array<double, 4> heights{};
    for (int k = 0; k < 4; ++k) heights[k] = height(std::lerp(borders[i], borders[i + 1], k / 3.0));
    const auto root = first_root(cubic_through(heights));
    if (root) return std::lerp(borders[i], borders[i + 1], *root);
  }
  return std::nullopt;
}

}  // namespace cutaway::reference
