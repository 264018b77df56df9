#include "render/ray_cast_pass.h"

#include <algorithm>

#include "render/lenses/lens_registry.h"

namespace cutaway {

namespace {

/// One secant step and this many bisections: 1/16 of a step at worst, far less on the usual nearly
/// linear ramp.
constexpr int kRefinementSteps = 5;

void set_lens(const gl::Program& program, const LensShape& shape, const Lens& lens) {
  program.set("lens_enabled", lens.mode != LensMode::none && lens.radius_mm > 0.0 ? 1 : 0);
  program.set("flat_caps", lens.cap == LensCap::flat ? 1 : 0);
  program.set("open_caps", lens.cap == LensCap::open ? 1 : 0);
  shape.set_parameters(program, lens);
}

void set_search(const gl::Program& program, const RayCastKey& key, const GpuVolume& volume) {
  const glm::dvec3 spacing = volume.volume().geometry.spacing_mm;
  const double smallest_mm = std::min({spacing.x, spacing.y, spacing.z});
  program.set("step_mm", static_cast<float>(key.step_voxels * smallest_mm));
  program.set("refinement_steps", kRefinementSteps);
  program.set("skip_empty_space", key.skip_empty_space ? 1 : 0);
  program.set("iso_values", glm::vec2(volume.to_stored(key.context_iso_value),
                                      volume.to_stored(key.focus_iso_value)));
}

}  // namespace

RayCastPass::RayCastPass(const gl::ShaderLibrary& shaders) {
  for (const LensShape& shape : lens_shapes()) {
    const std::string file = "\"" + std::string(shape.shader) + "\"";
    programs_.emplace(shape.name,
                      Entry{&shape, gl::Program(shaders, "fullscreen.vert", "ray_cast.frag",
                                                {{"LENS_SHAPE", file}})});
  }
}

void RayCastPass::run(const RayCastKey& key, GpuVolume& volume, const ViewBuffers& buffers,
                      const gl::FullscreenTriangle& triangle) {
  const Entry& entry = programs_.at(key.lens.shape.name);
  const gl::Program& program = entry.program;
  program.use();
  volume.set_uniforms(program, 0);
  volume.set_empty_space(program, 1, key.context_iso_value, key.focus_iso_value);
  set_view_rays(program, key.rays);
  program.set("surface_size_px", buffers.surface_size_px());
  set_search(program, key, volume);
  set_lens(program, *entry.shape, key.lens);
  buffers.surface_target.bind();
  triangle.draw();
}

}  // namespace cutaway
