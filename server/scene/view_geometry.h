// Pixels and rays: the one place that says how a camera maps patient space to a viewport.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace cutaway {

/// Orthonormal camera axes in patient space: right x up = towards the viewer (backward).
struct CameraAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 backward;
};
CameraAxes camera_axes(const Camera& camera);

struct ViewRay {
  glm::dvec3 origin_mm;
  glm::dvec3 direction;  ///< unit length
};

/// The ray through a point of the viewport; (0,0) is the upper left corner of the upper left pixel,
/// whose centre is at (0.5,0.5).
ViewRay ray_through(const Camera& camera, Viewport viewport, glm::dvec2 position_px);

/// Where a patient point appears in the viewport; nothing where it is behind the eye.
std::optional<glm::dvec2> project_px(const Camera& camera, Viewport viewport, glm::dvec3 point_mm);

/// Height of one pixel in mm at the given patient point's depth.
double pixel_size_mm(const Camera& camera, Viewport viewport, glm::dvec3 point_mm);

/// Unit vector towards the light in patient space.
glm::dvec3 light_direction_patient(const Light& light, const Camera& camera);

}  // namespace cutaway
