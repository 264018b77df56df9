// Pixels and rays of the reference renderer.
#pragma once

#include <cmath>

#include "scene/scene.h"
#include "scene/view_geometry.h"

namespace cutaway::reference {

/// Through the middle of the one at `at` among `size_px` over the whole viewport.
inline ViewRay ray_of(const Scene& scene, glm::ivec2 at, glm::ivec2 size_px) {
  const glm::dvec2 viewport(scene.viewport.width_px, scene.viewport.height_px);
  return ray_through(scene.camera, scene.viewport,
                     (glm::dvec2(at) + 0.5) * viewport / glm::dvec2(size_px));
}

/// Of neighbouring ones among `high` over the picture's height, at that distance.
inline double ray_spacing_mm(const Camera& camera, int high, double distance_mm) {
  return camera.projection == Projection::orthographic
             ? camera.view_height_mm / high
             : 2.0 * std::tan(0.5 * glm::radians(camera.vertical_fov_degrees)) * distance_mm / high;
}

}  // namespace cutaway::reference
