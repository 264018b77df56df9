#include "render/shade_pass.h"

#include <algorithm>
#include <string>

#include "core/check.h"
#include "render/shading/shading_registry.h"

namespace cutaway {

ShadePass::ShadePass(const gl::ShaderLibrary& shaders) {
  for (const ShadingModel& model : shading_models()) {
    for (const BranchIndex branch : {kContext, kFocus}) {
      for (int supersampling = 1; supersampling <= kMostSupersampling; ++supersampling) {
        auto definitions = shader_definitions(model);
        definitions["BRANCH"] = branch == kContext ? "CONTEXT" : "FOCUS";
        definitions["SUPERSAMPLING"] = std::to_string(supersampling);
        programs_.push_back({&model, branch, supersampling,
                             gl::Program(shaders, "rays.vert", "shade.frag", definitions)});
      }
    }
  }
}

void ShadePass::run(const ShadeKey& key, BranchIndex index, const BranchBuffers& branch,
                    const gl::PixelRect& strip, int supersampling,
                    const gl::FullscreenTriangle& triangle) const {
  const ShadingModel& model = find_shading_model(key.lit.shading.name);
  const auto entry = std::ranges::find_if(programs_, [&](const Entry& each) {
    return each.model == &model && each.branch == index && each.supersampling == supersampling;
  });
  check(entry != programs_.end(), "there is a program for each model, branch and supersampling");
  const gl::Program& program = entry->program;
  program.use();
  program.set_texture("surface_texture", 0, branch.surface.name());
  program.set("light_direction", key.lit.light_direction);
  set_view_rays(program, key.rays);
  model.set_parameters(UniformStruct(program, model.name, index), key.lit.shading.parameters);
  branch.shade_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
