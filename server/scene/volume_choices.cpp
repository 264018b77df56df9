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
  if (volume.slab) return clamped_position(volume.slab->centre_mm);
  return clamped_position(0.5 * (volume.bounds_minimum_mm + volume.bounds_maximum_mm));
}

glm::dvec3 slices_centre_mm(const VolumeFacts& volume) {
  return clamped_position(volume.grid_centre_mm);
}

glm::dvec3 chosen_crosshair_mm(const VolumeFacts& volume) {
  return clamped_position(volume.middle_voxel_mm);
}

namespace {

/// The first view's axes and half of what there is to see along them, mm.
struct FirstView {
  glm::dvec3 to_viewer;
  glm::dvec3 up;
  glm::dvec3 half_mm;  ///< to the right, up, to the viewer
};

glm::dvec3 half_along(const glm::dmat3& half_axes_mm, const glm::dmat3& directions) {
  const glm::dmat3 seen = glm::transpose(directions) * half_axes_mm;
  return glm::abs(seen[0]) + glm::abs(seen[1]) + glm::abs(seen[2]);
}

FirstView first_view(const VolumeFacts& volume) {
  FirstView view{kAnterior, kSuperior, {}};
  glm::dmat3 half_axes_mm(0.0);
  for (int axis = 0; axis < 3; ++axis)
    half_axes_mm[axis][axis] = 0.5 * (volume.bounds_maximum_mm - volume.bounds_minimum_mm)[axis];
  if (volume.slab) {
    view = {volume.slab->to_viewer, volume.slab->up, {}};
    half_axes_mm = volume.slab->half_axes_mm;
  }
  const glm::dmat3 axes(glm::cross(view.up, view.to_viewer), view.up, view.to_viewer);
  view.half_mm = half_along(half_axes_mm, axes);
  return view;
}

}  // namespace

glm::dvec3 chosen_up(const VolumeFacts& volume, glm::dvec3 view_direction) {
  constexpr double kNearlyVertical = 1e-3;
  const glm::dvec3 direction = glm::normalize(view_direction);
  if (volume.slab && glm::length(direction + volume.slab->to_viewer) < kNearlyVertical)
    return volume.slab->up;
  const double sine = glm::length(glm::cross(direction, kSuperior));
  return sine > kNearlyVertical ? kSuperior : kAnterior;
}

double chosen_view_height_mm(const VolumeFacts& volume, Viewport viewport) {
  const glm::dvec3 half_mm = first_view(volume).half_mm;
  const double height_mm =
      2.0 * kFramingMargin * std::max(half_mm.y, half_mm.x / aspect_of(viewport));
  return clamped(height_mm, "/properties/camera/properties/view_height_mm");
}

glm::dvec3 chosen_eye_mm(const VolumeFacts& volume, Viewport viewport, glm::dvec3 target_mm,
                         double vertical_fov_degrees) {
  const FirstView view = first_view(volume);
  const double half_height_mm = 0.5 * chosen_view_height_mm(volume, viewport);
  const double to_front_mm = half_height_mm / std::tan(glm::radians(vertical_fov_degrees) / 2.0);
  return clamped_position(target_mm + view.to_viewer * (to_front_mm + view.half_mm.z));
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
