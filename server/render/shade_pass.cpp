#include "render/shade_pass.h"

#include "render/shading/shading_registry.h"

namespace cutaway {

ShadePass::ShadePass(const gl::ShaderLibrary& shaders) {
  for (const ShadingModel& model : shading_models()) {
    const std::string file = "\"" + std::string(model.shader) + "\"";
    programs_.emplace(model.name,
                      Entry{&model, gl::Program(shaders, "fullscreen.vert", "shade.frag",
                                                {{"SHADING_MODEL", file}})});
  }
}

void ShadePass::run(const ShadeKey& key, const BranchBuffers& branch, int supersampling,
                    const gl::FullscreenTriangle& triangle) {
  const Entry& entry = programs_.at(key.shading.name);
  const gl::Program& program = entry.program;
  program.use();
  program.set_texture("surface_texture", 0, branch.surface.name());
  program.set("supersampling", supersampling);
  program.set("light_direction", key.light_direction);
  set_view_rays(program, key.rays);
  entry.model->set_parameters(program, key.shading.parameters);
  branch.shade_target.bind();
  triangle.draw();
}

}  // namespace cutaway
