#include "scene/slice_geometry.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// Of the volume's size, so that its edge is seen to be one.
constexpr double kSliceFramingMargin = 1.02;

struct Plane {
  glm::dvec3 toward_viewer;
  glm::dvec3 up;
  const SliceView* view;
};

// Radiologists look from the feet and from the front, neurologists from the head and from behind;
// both from the patient's left at sagittal slices.
Plane plane_of(const Slices& slices, ViewKind kind) {
  const double side = slices.convention == SliceConvention::radiological ? 1.0 : -1.0;
  if (kind == ViewKind::axial) return {-side * slices.superior, slices.anterior, &slices.axial};
  if (kind == ViewKind::coronal) return {side * slices.anterior, slices.superior, &slices.coronal};
  check(kind == ViewKind::sagittal, "the viewport shows a slice");
  const glm::dvec3 left = glm::cross(slices.superior, slices.anterior);
  return {left, slices.superior, &slices.sagittal};
}

/// How far the volume reaches from its centre in a direction.
double half_extent_mm(const glm::dmat3& grid_half_axes_mm, glm::dvec3 direction) {
  const glm::dvec3 along = glm::transpose(grid_half_axes_mm) * direction;
  return std::abs(along.x) + std::abs(along.y) + std::abs(along.z);
}

double whole_height_mm(const glm::dmat3& half_axes_mm, const CameraAxes& axes, Viewport viewport) {
  const double aspect = double(viewport.height_px) / viewport.width_px;
  return 2.0 * kSliceFramingMargin *
         std::max(half_extent_mm(half_axes_mm, axes.up),
                  half_extent_mm(half_axes_mm, axes.right) * aspect);
}

bool show_the_same_slice(const Scene& a, const Scene& b) {
  // Of a crosshair that moves within the plane, by rounding.
  constexpr double kSamePlane_mm = 1e-9;
  const Plane plane = plane_of(a.slices, a.viewport.kind);
  const Plane other = plane_of(b.slices, b.viewport.kind);
  const double apart_mm =
      glm::dot(a.slices.crosshair_mm - b.slices.crosshair_mm, plane.toward_viewer);
  return plane.toward_viewer == other.toward_viewer && plane.up == other.up &&
         *plane.view == *other.view && std::abs(apart_mm) < kSamePlane_mm &&
         a.slices.window == b.slices.window;
}

}  // namespace

bool show_the_same(const Scene& a, const Scene& b) {
  if (a.volume != b.volume || a.viewport != b.viewport) return false;
  if (a.viewport.kind != ViewKind::volume) return show_the_same_slice(a, b);
  Scene like_a = b;
  like_a.slices = a.slices;
  return a == like_a;
}

Camera slice_camera(const Scene& scene, const glm::dmat3& grid_half_axes_mm) {
  const Slices& slices = scene.slices;
  const Plane plane = plane_of(slices, scene.viewport.kind);
  const glm::dvec3 normal = plane.toward_viewer;
  const glm::dvec3 centre_mm = plane.view->centre_mm;
  Camera camera{.projection = Projection::orthographic, .up = plane.up};
  camera.eye_mm = centre_mm + normal * glm::dot(slices.crosshair_mm - centre_mm, normal);
  camera.target_mm = camera.eye_mm - normal;
  camera.view_height_mm = plane.view->view_height_mm.value_or(
      whole_height_mm(grid_half_axes_mm, camera_axes(camera), scene.viewport));
  return camera;
}

}  // namespace cutaway
