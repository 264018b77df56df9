#include "render/normals_pass.h"

#include <string>

#include "render/normal_taps.h"
#include "render/spline_taps.h"

namespace cutaway {

namespace {

gl::Program cubic_program(const gl::ShaderLibrary& shaders, std::size_t taps) {
  return {shaders, "rays.vert", "normals_cubic.frag", {{"TAPS", std::to_string(taps)}}};
}

std::string element(const char* array, std::size_t index) {
  return array + ("[" + std::to_string(index) + "]");
}

void set_taps(const gl::Program& program, const NormalTaps& taps, const VolumeGeometry& geometry) {
  for (std::size_t i = 0; i < taps.pairs.size(); ++i) {
    const glm::dvec3 offset = taps.pairs[i].offset_voxels / glm::dvec3(geometry.size_voxels);
    program.set(element("pair_offset", i).c_str(), glm::vec3(offset));
    program.set(element("pair_gradient", i).c_str(), glm::vec3(taps.pairs[i].gradient));
  }
}

void set_taps(const gl::Program& program, const SplineTaps& taps, const VolumeGeometry& geometry) {
  for (std::size_t i = 0; i < taps.taps.size(); ++i) {
    const glm::dvec3 offset = taps.taps[i].offset_voxels / glm::dvec3(geometry.size_voxels);
    program.set(element("tap_offset", i).c_str(), glm::vec3(offset));
    program.set(element("tap_weight", i).c_str(), static_cast<float>(taps.taps[i].weight));
  }
}

/// Slopes per texel into gradients in patient space, per mm.
glm::mat3 patient_from_slope(const VolumeGeometry& geometry, glm::ivec3 factor) {
  glm::dmat3 axes = geometry.direction_patient;
  for (int axis = 0; axis < 3; ++axis) axes[axis] /= factor[axis] * geometry.spacing_mm[axis];
  return axes;
}

}  // namespace

NormalsPass::NormalsPass(const gl::ShaderLibrary& shaders)
    : linear_(shaders, "rays.vert", "normals.frag", {{"PAIRS", std::to_string(kTapPairs)}}),
      cubic_(cubic_program(shaders, 1)),
      cubic_at_scale_(cubic_program(shaders, kScaledTaps)) {}

const gl::Program& NormalsPass::use_linear(const NormalsKey& key, const GpuVolume& volume) const {
  const VolumeGeometry& geometry = volume.volume().geometry;
  const NormalTaps taps = normal_taps(key.scale_mm, geometry, volume.level_factors());
  linear_.use();
  volume.set_level(linear_, 1, taps.level);
  linear_.set("voxel_size", glm::vec3(1.0 / glm::dvec3(geometry.size_voxels)));
  set_taps(linear_, taps, geometry);
  return linear_;
}

const gl::Program& NormalsPass::use_cubic(const NormalsKey& key, const GpuVolume& volume) const {
  const VolumeGeometry& geometry = volume.volume().geometry;
  const std::vector<glm::ivec3> factors = volume.level_factors();
  const SplineTaps taps = spline_taps(key.scale_mm, geometry, factors);
  const gl::Program& program = taps.taps.size() == 1 ? cubic_ : cubic_at_scale_;
  program.use();
  volume.set_level(program, 1, taps.level);
  volume.set_uniforms(program, 2);
  program.set("band", volume.to_stored(key.band));
  program.set("patient_from_slope", patient_from_slope(geometry, factors.at(taps.level)));
  set_taps(program, taps, geometry);
  return program;
}

void NormalsPass::run(const NormalsKey& key, const GpuVolume& volume, const BranchBuffers& branch,
                      const gl::PixelRect& strip, int supersampling,
                      const gl::FullscreenTriangle& triangle) const {
  const bool is_cubic = key.reconstruction == Reconstruction::cubic;
  const gl::Program& program = is_cubic ? use_cubic(key, volume) : use_linear(key, volume);
  program.set_texture("surface_texture", 0, branch.surface.name());
  set_view_rays(program, key.rays, supersampling);
  branch.calmed_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
