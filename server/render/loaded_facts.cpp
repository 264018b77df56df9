#include "render/loaded_facts.h"

#include <cmath>
#include <utility>

#include "render/scene_preparation.h"
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

/// From the front, the left or the feet, as slices are looked at.
glm::dvec3 towards_viewer(glm::dvec3 normal) {
  const glm::dvec3 size = glm::abs(normal);
  if (size.x > size.y && size.x > size.z) return normal.x > 0.0 ? normal : -normal;
  return (size.y > size.z ? normal.y : normal.z) < 0.0 ? normal : -normal;
}

SlabView slab_view(const MaterialShape& shape) {
  SlabView slab{.centre_mm = shape.centre_mm, .half_axes_mm = shape.axes};
  for (int axis = 0; axis < 3; ++axis) slab.half_axes_mm[axis] *= shape.half_size_mm[axis];
  slab.to_viewer = towards_viewer(shape.axes[2]);
  const bool is_from_below = std::abs(slab.to_viewer.z) > std::sqrt(0.5);
  const glm::dvec3 up = is_from_below ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  slab.up = glm::normalize(up - glm::dot(up, slab.to_viewer) * slab.to_viewer);
  return slab;
}

/// NIfTI knows no modality and is the format of MR; a CT that is kept in it has its air below 0.
bool may_be_mr(const LoadedVolume& loaded) {
  return loaded.findings.kind == DataKind::unknown && loaded.volume.description.format == "NIfTI" &&
         loaded.histogram.range.minimum >= 0.0;
}

std::string first_style(const LoadedVolume& loaded) {
  if (loaded.findings.has_contrast) return "angiography";
  return loaded.findings.kind == DataKind::mr || may_be_mr(loaded) ? "brain" : "flagship";
}

}  // namespace

VolumeFacts facts_of(const LoadedVolume& loaded, std::shared_ptr<const LoadedVolume> seen) {
  const Volume& volume = loaded.volume;
  const BoundingBox& bounds = loaded.material_bounds_mm;
  const ValueRange window = suggest_window(volume.description, loaded.histogram);
  VolumeFacts facts{.id = volume.description.id,
                    .bounds_minimum_mm = bounds.minimum_mm,
                    .bounds_maximum_mm = bounds.maximum_mm,
                    .diagonal_mm = glm::length(bounds.maximum_mm - bounds.minimum_mm),
                    .grid_centre_mm = centre_mm(volume.geometry),
                    .middle_voxel_mm = middle_voxel_mm(volume.geometry),
                    .grid_half_axes_mm = half_axes_mm(volume.geometry),
                    .outermost_share = 1.0 - 1.0 / glm::dvec3(volume.geometry.size_voxels),
                    .minimum_value = loaded.histogram.range.minimum,
                    .maximum_value = loaded.histogram.range.maximum,
                    .outer_iso_value = loaded.findings.outer.value,
                    .inner_iso_value = loaded.findings.inner.value,
                    .window_centre = 0.5 * (window.minimum + window.maximum),
                    .window_width = window.maximum - window.minimum};
  if (loaded.findings.shape.is_slab()) facts.slab = slab_view(loaded.findings.shape);
  facts.first_style = first_style(loaded);
  facts.first_preparation = first_preparation(loaded.findings);
  facts.first_surface_mm = probe_of(std::move(seen));
  return facts;
}

VolumeFacts facts_of(const std::shared_ptr<const LoadedVolume>& loaded) {
  return facts_of(*loaded, loaded);
}

SurfaceProbe probe_of(std::shared_ptr<const LoadedVolume> volume) {
  return [held = std::move(volume)](glm::dvec3 origin_mm, glm::dvec3 direction,
                                    const ValueBand& band) {
    return first_point(held->volume, {origin_mm, direction}, band);
  };
}

}  // namespace cutaway
