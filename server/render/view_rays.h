// A camera as the shaders want it.
#pragma once

#include <glm/glm.hpp>

#include "gl/program.h"
#include "render/render_settings.h"
#include "scene/scene.h"
#include "volume/geometry.h"

namespace cutaway {

/// The uniforms of shaders/view.glsl. Computed in double, patient mm and the volume's texture
/// coordinates.
struct ViewRays {
  glm::vec3 eye_mm;
  glm::vec3 view_forward;
  glm::vec3 view_right;
  glm::vec3 view_up;
  bool is_perspective;
  glm::mat3 patient_to_volume;
  glm::vec3 eye_in_volume;
  glm::vec2 first_px{0.0F};  ///< of the part, in the whole picture
  glm::vec2 whole_px{1.0F};
  glm::vec2 tile_centre{0.0F};
  glm::vec2 tile_scale{1.0F};
  bool operator==(const ViewRays&) const = default;
};

ViewRays view_rays(const Camera& camera, Viewport viewport, const VolumeGeometry& geometry);

/// The same for a part of the picture.
ViewRays in_tile(ViewRays rays, const RenderSettings& settings);

/// `fragments`: drawn for a pixel of the picture, each way.
void set_view_rays(const gl::Program& program, const ViewRays& rays, int fragments = 1);

}  // namespace cutaway
