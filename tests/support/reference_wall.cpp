#include "support/reference_wall.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutaway::reference {

namespace {

double value_at_mm(const Volume& volume, glm::dvec3 position_mm) {
  return sample(volume,
                glm::dvec3(patient_to_index(volume.geometry) * glm::dvec4(position_mm, 1.0)));
}

glm::dvec3 tissue(const Tissues& tissues, double value) {
  const double share =
      (value - tissues.range.minimum) / (tissues.range.maximum - tissues.range.minimum);
  const double last = static_cast<double>(tissues.colours.size() - 1);
  const double at = std::clamp(share, 0.0, 1.0) * last;
  const double below = std::min(std::floor(at), last - 1.0);
  const auto index = static_cast<std::size_t>(below);
  return glm::mix(tissues.colours[index], tissues.colours[index + 1], at - below);
}

/// Of twelve directions along the cut the share in which the context ends within the edge's width;
/// a quarter of them is all of it.
double edge(const Scene& scene, const Volume& volume, glm::dvec3 position_mm, glm::dvec3 normal) {
  const double width_mm = scene.lens.wall.edge_mm;
  if (width_mm <= 0.0) return 0.0;
  const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 aside = glm::normalize(glm::cross(normal, helper));
  const glm::dvec3 across = glm::cross(normal, aside);
  double ends = 0.0;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 12.0;
    const double value = value_at_mm(
        volume, position_mm + width_mm * (std::cos(angle) * aside + std::sin(angle) * across));
    if (value < scene.context.surface.band.lower || value > scene.context.surface.band.upper)
      ends += 1.0;
  }
  return std::min(ends / 3.0, 1.0);
}

}  // namespace

bool has_wall(const Scene& scene) {
  const Lens& lens = scene.lens;
  const bool cuts = lens.mode == LensMode::cutaway && lens.radius_mm > 0.0;
  return lens.cap == LensCap::section ||
         (cuts &&
          (lens.wall.strength > 0.0 || lens.wall.deepening > 0.0 || lens.wall.edge_mm > 0.0));
}

glm::dvec3 wall(const Scene& scene, const Volume& volume, const Tissues& tissues,
                const BranchLayers& layers, const ViewRay& ray, glm::dvec3 shaded) {
  const Lens& lens = scene.lens;
  const glm::dvec3 normal = layers.nearest.normal;
  const bool is_cut = layers.nearest.is_cut;
  const glm::dvec3 position_mm = ray.origin_mm + layers.nearest.distance_mm * ray.direction;
  glm::dvec3 colour = shaded;
  if (lens.cap == LensCap::section && (is_cut || layers.is_behind_lens)) {
    const glm::dvec3 under_mm = is_cut ? position_mm : position_mm - 2.0 * normal;
    const double light =
        0.85 + 0.15 * glm::dot(normal, light_direction_patient(scene.light, scene.camera));
    colour = light * tissue(tissues, value_at_mm(volume, under_mm));
  }
  if (!layers.is_behind_lens) return colour;
  colour = glm::mix(colour, lens.wall.colour, lens.wall.strength);
  if (is_cut)
    colour = glm::mix(colour, lens.wall.edge_colour, edge(scene, volume, position_mm, normal));
  const glm::dvec3 forward = -camera_axes(scene.camera).backward;
  const double depth_mm = std::max(glm::dot(position_mm - lens.centre_mm, forward), 0.0);
  return colour * std::exp(-lens.wall.deepening * depth_mm / std::max(lens.radius_mm, 1e-3));
}

}  // namespace cutaway::reference
