#include "render/loaded_facts.h"

#include <utility>

#include "volume/ray_probe.h"

namespace cutaway {

namespace {

std::optional<glm::dvec3> first_point(const Volume& volume, const PatientRay& ray,
                                      const ValueBand& band) {
  const auto limits = intersect_grid(volume.geometry, ray);
  if (!limits) return std::nullopt;
  const auto distance_mm = first_surface_mm(volume, ray, band, *limits);
  if (!distance_mm) return std::nullopt;
  return ray.origin_mm + *distance_mm * ray.direction;
}

}  // namespace

VolumeFacts facts_of(std::shared_ptr<const LoadedVolume> loaded) {
  const Volume& volume = loaded->volume;
  const BoundingBox& bounds = loaded->material_bounds_mm;
  const ValueRange window = suggest_window(volume.description, loaded->histogram);
  VolumeFacts facts{.id = volume.description.id,
                    .bounds_minimum_mm = bounds.minimum_mm,
                    .bounds_maximum_mm = bounds.maximum_mm,
                    .diagonal_mm = glm::length(bounds.maximum_mm - bounds.minimum_mm),
                    .grid_centre_mm = centre_mm(volume.geometry),
                    .middle_voxel_mm = middle_voxel_mm(volume.geometry),
                    .grid_half_axes_mm = half_axes_mm(volume.geometry),
                    .minimum_value = loaded->histogram.range.minimum,
                    .maximum_value = loaded->histogram.range.maximum,
                    .outer_iso_value = loaded->surfaces.outer_iso_value,
                    .inner_iso_value = loaded->surfaces.inner_iso_value,
                    .window_centre = 0.5 * (window.minimum + window.maximum),
                    .window_width = window.maximum - window.minimum};
  facts.first_surface_mm = [held = std::move(loaded)](glm::dvec3 origin_mm, glm::dvec3 direction,
                                                      const ValueBand& band) {
    return first_point(held->volume, {origin_mm, direction}, band);
  };
  return facts;
}

}  // namespace cutaway
