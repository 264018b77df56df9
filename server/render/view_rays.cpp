#include "render/view_rays.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// To texture coordinates, of which voxel centres lie at (index + 1/2) / size.
glm::dmat4 patient_to_volume(const VolumeGeometry& geometry) {
  const glm::dvec3 voxel_size = 1.0 / glm::dvec3(geometry.size_voxels);
  const glm::dmat4 to_volume =
      glm::translate(glm::scale(glm::dmat4(1.0), voxel_size), glm::dvec3(0.5));
  return to_volume * patient_to_index(geometry);
}

}  // namespace

ViewRays view_rays(const Camera& camera, Viewport viewport, const VolumeGeometry& geometry) {
  const CameraAxes axes = camera_axes(camera);
  const bool perspective = camera.projection == Projection::perspective;
  const double half_height = perspective ? std::tan(glm::radians(camera.vertical_fov_degrees) / 2.0)
                                         : camera.view_height_mm / 2.0;
  const double aspect = static_cast<double>(viewport.width_px) / viewport.height_px;
  const glm::dmat4 to_volume = patient_to_volume(geometry);
  return {.eye_mm = camera.eye_mm,
          .view_forward = -axes.backward,
          .view_right = axes.right * (half_height * aspect),
          .view_up = axes.up * half_height,
          .is_perspective = perspective,
          .patient_to_volume = glm::mat3(to_volume),
          .eye_in_volume = glm::vec3(to_volume * glm::dvec4(camera.eye_mm, 1.0))};
}

ViewRays in_tile(ViewRays rays, const RenderSettings& settings) {
  const PictureTile tile = tile_of(settings);
  const glm::dvec2 whole(tile.whole_size_px);
  const glm::dvec2 size(settings.picture_size_px);
  rays.first_px = tile.begin_px;
  rays.whole_px = tile.whole_size_px;
  rays.tile_scale = size / whole;
  rays.tile_centre = (2.0 * glm::dvec2(tile.begin_px) + size) / whole - 1.0;
  return rays;
}

void set_view_rays(const gl::Program& program, const ViewRays& rays, int fragments) {
  program.set("eye_mm", rays.eye_mm);
  program.set("view_forward", rays.view_forward);
  program.set("view_right", rays.view_right);
  program.set("view_up", rays.view_up);
  program.set("is_perspective", rays.is_perspective ? 1 : 0);
  program.set("patient_to_volume", rays.patient_to_volume);
  program.set("eye_in_volume", rays.eye_in_volume);
  program.set("first_fragment", rays.first_px * static_cast<float>(fragments));
  program.set("whole_fragments", rays.whole_px * static_cast<float>(fragments));
  program.set("tile_centre", rays.tile_centre);
  program.set("tile_scale", rays.tile_scale);
}

}  // namespace cutaway
