#include "render/shade_pass.h"

#include <algorithm>
#include <string>

#include "core/check.h"
#include "render/shading/shading_registry.h"

namespace cutaway {

ShadePass::ShadePass(const gl::ShaderLibrary& shaders) {
  for (const ShadingModel& model : shading_models()) {
    add_programs(shaders, model, false);
    if (model.reads_turning != nullptr) add_programs(shaders, model, true);
  }
}

void ShadePass::add_programs(const gl::ShaderLibrary& shaders, const ShadingModel& model,
                             bool turns) {
  for (const BranchIndex branch : {kContext, kFocus}) {
    for (int supersampling = 1; supersampling <= kMostSupersampling; ++supersampling) {
      auto definitions = shader_definitions(model);
      definitions["BRANCH"] = branch == kContext ? "CONTEXT" : "FOCUS";
      definitions["SUPERSAMPLING"] = std::to_string(supersampling);
      if (turns) definitions["TURNS"] = "";
      programs_.push_back({&model, branch, supersampling, turns,
                           gl::Program(shaders, "rays.vert", "shade.frag", definitions)});
    }
  }
}

const ShadePass::Entry& ShadePass::find_entry(const ShadeKey& key, BranchIndex branch,
                                              int supersampling) const {
  const ShadingModel& model = find_shading_model(key.lit.shading.name);
  const bool turns = reads_turning(key.lit.shading);
  const auto entry = std::ranges::find_if(programs_, [&](const Entry& each) {
    return each.model == &model && each.branch == branch && each.turns == turns &&
           each.supersampling == supersampling;
  });
  check(entry != programs_.end(), "there is a program for each model, branch and supersampling");
  return *entry;
}

void ShadePass::run(const ShadeKey& key, BranchIndex index, const BranchBuffers& branch,
                    const gl::PixelRect& strip, int supersampling,
                    const gl::FullscreenTriangle& triangle) const {
  const Entry& entry = find_entry(key, index, supersampling);
  const UniformStruct uniforms(entry.program, entry.model->name, index);
  const Json& parameters = key.lit.shading.parameters;
  entry.program.use();
  entry.program.set_texture("surface_texture", 0, branch.surface.name());
  entry.program.set("light_direction", key.lit.light_direction);
  set_view_rays(entry.program, key.rays);
  entry.model->set_parameters(uniforms, parameters);
  if (entry.turns)
    entry.model->set_turning(uniforms, parameters, key.resolution_scale * supersampling);
  branch.shade_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
