#include "scene/volume_choices.h"

#include <algorithm>
#include <cmath>

#include "scene/schema.h"

namespace cutaway {

namespace {

constexpr double kFramingMargin = 1.05;
constexpr double kLensShareOfDiagonal = 0.15;
constexpr const char* kLensRadius = "/properties/lens/properties/radius_mm";
constexpr glm::dvec3 kSuperior{0.0, 0.0, 1.0};
constexpr glm::dvec3 kAnterior{0.0, -1.0, 0.0};

double clamped(double value, const char* schema_pointer) {
  const NumberRange range = number_range("scene", schema_pointer);
  return std::clamp(value, range.minimum, range.maximum);
}

/// What was chosen must be a legal document too: a patch of it is checked whole.
glm::dvec3 clamped_position(glm::dvec3 position_mm) {
  const NumberRange range = number_range("scene", "/properties/camera/properties/eye_mm/items");
  return glm::clamp(position_mm, range.minimum, range.maximum);
}

double aspect_of(Viewport viewport) {
  if (viewport.width_px <= 0 || viewport.height_px <= 0) return 1.0;
  return static_cast<double>(viewport.width_px) / viewport.height_px;
}

}  // namespace

glm::dvec3 volume_centre_mm(const VolumeFacts& volume) {
  return clamped_position(0.5 * (volume.bounds_minimum_mm + volume.bounds_maximum_mm));
}

glm::dvec3 slices_centre_mm(const VolumeFacts& volume) {
  return clamped_position(volume.grid_centre_mm);
}

glm::dvec3 chosen_crosshair_mm(const VolumeFacts& volume) {
  return clamped_position(volume.middle_voxel_mm);
}

glm::dvec3 chosen_up(glm::dvec3 view_direction) {
  constexpr double kNearlyVertical = 1e-3;
  const double sine = glm::length(glm::cross(glm::normalize(view_direction), kSuperior));
  return sine > kNearlyVertical ? kSuperior : kAnterior;
}

double chosen_view_height_mm(const VolumeFacts& volume, Viewport viewport) {
  const glm::dvec3 size_mm = volume.bounds_maximum_mm - volume.bounds_minimum_mm;
  const double height_mm = kFramingMargin * std::max(size_mm.z, size_mm.x / aspect_of(viewport));
  return clamped(height_mm, "/properties/camera/properties/view_height_mm");
}

glm::dvec3 chosen_eye_mm(const VolumeFacts& volume, Viewport viewport, glm::dvec3 target_mm,
                         double vertical_fov_degrees) {
  const double depth_mm = volume.bounds_maximum_mm.y - volume.bounds_minimum_mm.y;
  const double half_height_mm = 0.5 * chosen_view_height_mm(volume, viewport);
  const double to_front_mm = half_height_mm / std::tan(glm::radians(vertical_fov_degrees) / 2.0);
  return clamped_position(target_mm + kAnterior * (to_front_mm + 0.5 * depth_mm));
}

PlacedLens chosen_lens(const VolumeFacts& volume, const LensPlacementView& view,
                       std::optional<double> radius_mm) {
  LensPlacementView seen = view;
  if (seen.viewport.width_px <= 0 || seen.viewport.height_px <= 0) seen.viewport = {1, 1};
  const double usual_mm = radius_mm.value_or(kLensShareOfDiagonal * volume.diagonal_mm);
  PlacedLens lens =
      placed_lens(volume, seen, usual_mm).value_or(PlacedLens{volume_centre_mm(volume), usual_mm});
  lens.centre_mm = clamped_position(lens.centre_mm);
  lens.radius_mm = radius_mm.value_or(clamped(lens.radius_mm, kLensRadius));
  return lens;
}

}  // namespace cutaway
