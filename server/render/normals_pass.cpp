#include "render/normals_pass.h"

#include <string>

#include "render/normal_taps.h"

namespace cutaway {

namespace {

gl::Program program_for(const gl::ShaderLibrary& shaders, std::size_t pairs) {
  return {shaders, "rays.vert", "normals.frag", {{"PAIRS", std::to_string(pairs)}}};
}

void set_taps(const gl::Program& program, const NormalTaps& taps, const VolumeGeometry& geometry) {
  for (std::size_t i = 0; i < taps.pairs.size(); ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    const glm::dvec3 offset = taps.pairs[i].offset_voxels / glm::dvec3(geometry.size_voxels);
    program.set(("pair_offset" + index).c_str(), glm::vec3(offset));
    program.set(("pair_gradient" + index).c_str(), glm::vec3(taps.pairs[i].gradient));
  }
}

}  // namespace

NormalsPass::NormalsPass(const gl::ShaderLibrary& shaders)
    : fine_(program_for(shaders, kFinePairs)), coarse_(program_for(shaders, kCoarsePairs)) {}

void NormalsPass::run(const NormalsKey& key, const GpuVolume& volume, const BranchBuffers& branch,
                      const gl::PixelRect& strip, int supersampling,
                      const gl::FullscreenTriangle& triangle) const {
  const VolumeGeometry& geometry = volume.volume().geometry;
  const NormalTaps taps = normal_taps(key.scale_mm, geometry, volume.level_factors());
  const gl::Program& program = taps.level == 0 ? fine_ : coarse_;
  program.use();
  program.set_texture("surface_texture", 0, branch.surface.name());
  volume.set_level(program, 1, taps.level);
  program.set("voxel_size", glm::vec3(1.0 / glm::dvec3(geometry.size_voxels)));
  set_taps(program, taps, geometry);
  set_view_rays(program, key.rays, supersampling);
  branch.calmed_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
