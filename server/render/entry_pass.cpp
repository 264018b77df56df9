#include "render/entry_pass.h"

#include <algorithm>
#include <limits>

namespace cutaway {

namespace {

/// Depths of the box' nearest and farthest corner along the view.
glm::vec2 depth_range_mm(const ViewRays& rays, const VolumeGeometry& geometry) {
  const glm::dmat4 to_patient = index_to_patient(geometry);
  const glm::dvec3 last(geometry.size_voxels - 1);
  glm::dvec2 range(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index = last * glm::dvec3(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    const glm::dvec3 at(to_patient * glm::dvec4(index, 1.0));
    const double depth = glm::dot(at - glm::dvec3(rays.eye_mm), glm::dvec3(rays.view_forward));
    range = {std::min(range.x, depth), std::max(range.y, depth)};
  }
  return range;
}

bool is_in_box(glm::vec3 in_volume, glm::ivec3 size_voxels) {
  constexpr float kBeside = 1.0F;  // cells
  const glm::vec3 index = in_volume * glm::vec3(size_voxels) - 0.5F;
  return glm::all(glm::greaterThan(index, glm::vec3(-kBeside))) &&
         glm::all(glm::lessThan(index, glm::vec3(size_voxels - 1) + kBeside));
}

}  // namespace

EntryKey entry_key(const GpuVolume& volume, const ViewRays& rays,
                   const std::array<ValueBand, kBranches>& bands, bool skip_empty_space) {
  const VolumeGeometry& geometry = volume.volume().geometry;
  const glm::vec2 depths = depth_range_mm(rays, geometry);
  const bool is_outside =
      rays.is_perspective ? !is_in_box(rays.eye_in_volume, geometry.size_voxels) : depths.x > 0.0F;
  return {.volume = volume.identity(),
          .rays = rays,
          .bands = bands,
          .is_used = skip_empty_space && is_outside,
          .farthest_mm = depths.y};
}

EntryPass::EntryPass(const gl::ShaderLibrary& shaders)
    : program_(shaders, "block_faces.vert", "block_faces.frag") {}

void EntryPass::run(const EntryKey& key, GpuVolume& volume, const ViewBuffers& buffers) const {
  buffers.entry_target.clear({glm::vec4(0.0F)});
  gl::Framebuffer::clear_depth(key.is_used ? gl::kFarthest : gl::kNearest);
  if (!key.is_used) return;
  const VolumeGeometry& geometry = volume.volume().geometry;
  const EmptySpaceMaps& maps = volume.empty_space(key.bands[kContext], key.bands[kFocus]);
  program_.use();
  volume.set_uniforms(program_, 0);
  set_view_rays(program_, key.rays);
  program_.set("first_centre_mm", glm::vec3(geometry.origin_patient_mm));
  program_.set("block_cells", maps.block_cells);
  program_.set("nearest_mm", static_cast<float>(0.5 * smallest_spacing_mm(geometry)));
  program_.set("farthest_mm", key.farthest_mm);
  const gl::DepthTest test(gl::DepthTest::keep_nearest);
  glBindVertexArray(maps.faces.name());
  glDrawArrays(GL_TRIANGLES, 0, maps.corner_count);
}

}  // namespace cutaway
