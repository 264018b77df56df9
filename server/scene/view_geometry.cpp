#include "scene/view_geometry.h"

#include <algorithm>
#include <cmath>

namespace cutaway {

namespace {

/// Half of what the viewport's height spans: mm for orthographic, per mm of depth for perspective.
double half_height(const Camera& camera) {
  return camera.projection == Projection::orthographic
             ? 0.5 * camera.view_height_mm
             : std::tan(0.5 * glm::radians(camera.vertical_fov_degrees));
}

/// Viewport units per pixel, the same in both directions: pixels are square.
double per_pixel(const Camera& camera, Viewport viewport) {
  return 2.0 * half_height(camera) / viewport.height_px;
}

glm::dvec2 middle_px(Viewport viewport) {
  return {0.5 * viewport.width_px, 0.5 * viewport.height_px};
}

}  // namespace

CameraAxes camera_axes(const Camera& camera) {
  const glm::dvec3 backward = glm::normalize(camera.eye_mm - camera.target_mm);
  const glm::dvec3 right = glm::normalize(glm::cross(-backward, camera.up));
  return {right, glm::cross(backward, right), backward};
}

ViewRay ray_through(const Camera& camera, Viewport viewport, glm::dvec2 position_px) {
  const CameraAxes axes = camera_axes(camera);
  const glm::dvec2 offset = (position_px - middle_px(viewport)) * per_pixel(camera, viewport);
  const glm::dvec3 across = axes.right * offset.x - axes.up * offset.y;
  if (camera.projection == Projection::orthographic)
    return {camera.eye_mm + across, -axes.backward};
  return {camera.eye_mm, glm::normalize(across - axes.backward)};
}

std::optional<glm::dvec2> project_px(const Camera& camera, Viewport viewport, glm::dvec3 point_mm) {
  const CameraAxes axes = camera_axes(camera);
  const glm::dvec3 from_eye = point_mm - camera.eye_mm;
  const double depth_mm = -glm::dot(from_eye, axes.backward);
  if (depth_mm <= 0.0) return {};
  const glm::dvec2 across{glm::dot(from_eye, axes.right), -glm::dot(from_eye, axes.up)};
  const double scale = pixel_size_mm(camera, viewport, point_mm);
  return middle_px(viewport) + across / scale;
}

double pixel_size_mm(const Camera& camera, Viewport viewport, glm::dvec3 point_mm) {
  if (camera.projection == Projection::orthographic) return per_pixel(camera, viewport);
  const glm::dvec3 backward = camera_axes(camera).backward;
  const double depth_mm = -glm::dot(point_mm - camera.eye_mm, backward);
  return std::max(depth_mm, 0.0) * per_pixel(camera, viewport);
}

glm::dvec3 light_direction_patient(const Light& light, const Camera& camera) {
  const glm::dvec3 direction = glm::normalize(light.direction);
  if (light.frame == LightFrame::patient) return direction;
  const CameraAxes axes = camera_axes(camera);
  return axes.right * direction.x + axes.up * direction.y + axes.backward * direction.z;
}

}  // namespace cutaway
