#include "volume/ray_probe.h"

#include <algorithm>
#include <limits>

namespace cutaway {

namespace {

/// The same ray in index space: its parameter is still the distance in mm.
PatientRay to_index(const VolumeGeometry& geometry, const PatientRay& ray) {
  const glm::dmat4 matrix = patient_to_index(geometry);
  return {glm::dvec3(matrix * glm::dvec4(ray.origin_mm, 1.0)),
          glm::dvec3(matrix * glm::dvec4(ray.direction, 0.0))};
}

RayInterval intersect_slab(double origin, double direction, double last) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (direction == 0.0) {
    const bool inside = 0.0 <= origin && origin <= last;
    return inside ? RayInterval{-kInfinity, kInfinity} : RayInterval{kInfinity, -kInfinity};
  }
  const double a = (0.0 - origin) / direction;
  const double b = (last - origin) / direction;
  return {std::min(a, b), std::max(a, b)};
}

RayInterval overlap(RayInterval a, RayInterval b) {
  return {std::max(a.begin_mm, b.begin_mm), std::min(a.end_mm, b.end_mm)};
}

}  // namespace

std::optional<RayInterval> intersect_grid(const VolumeGeometry& geometry, const PatientRay& ray) {
  const PatientRay local = to_index(geometry, ray);
  RayInterval inside{0.0, std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    inside = overlap(inside, intersect_slab(local.origin_mm[axis], local.direction[axis],
                                            geometry.size_voxels[axis] - 1));
  }
  return inside.begin_mm <= inside.end_mm ? std::optional(inside) : std::nullopt;
}

std::optional<double> first_surface_mm(const Volume& volume, const PatientRay& ray,
                                       const ValueBand& band, RayInterval limits) {
  constexpr int kBisections = 20;
  const std::optional<RayInterval> grid = intersect_grid(volume.geometry, ray);
  if (!grid) return std::nullopt;
  const RayInterval inside = overlap(*grid, limits);
  if (inside.begin_mm > inside.end_mm) return std::nullopt;

  const PatientRay local = to_index(volume.geometry, ray);
  const auto side = [&](double distance_mm) {
    return band.side(sample(volume, local.origin_mm + distance_mm * local.direction));
  };
  const int before = side(inside.begin_mm);
  if (before == 0) return inside.begin_mm;

  const double step_mm = 0.5 * smallest_spacing_mm(volume.geometry);
  double outside_mm = inside.begin_mm;
  for (long i = 1; outside_mm < inside.end_mm; ++i) {
    double here_mm = std::min(inside.begin_mm + double(i) * step_mm, inside.end_mm);
    if (side(here_mm) == before) {
      outside_mm = here_mm;
      continue;
    }
    for (int k = 0; k < kBisections; ++k) {
      const double middle_mm = 0.5 * (outside_mm + here_mm);
      (side(middle_mm) != before ? here_mm : outside_mm) = middle_mm;
    }
    return here_mm;
  }
  return std::nullopt;
}

}  // namespace cutaway
