#include "render/shade_pass.h"

#include <string>

#include "render/shading/shading_registry.h"
#include "render/tissue_ramp.h"

namespace cutaway {

namespace {

void set_relief(const gl::Program& program, const Relief& relief, const BranchBuffers& branch) {
  program.set_texture("reach_texture", 1, branch.reach.texture.name());
  program.set("occlusion_strength", static_cast<float>(relief.occlusion_strength));
  program.set("occlusion_colour", glm::vec3(relief.occlusion_colour));
  program.set("shadow_strength", static_cast<float>(relief.shadow_strength));
}

void set_tissues(const gl::Program& program, const GpuVolume& volume) {
  const TissueRamp& ramp = volume.tissues();
  for (int i = 0; i < kTissueColours; ++i)
    program.set(("tissue[" + std::to_string(i) + "]").c_str(), ramp.colours[i]);
  program.set("tissue_range", glm::vec2(volume.to_stored(ramp.range.minimum),
                                        volume.to_stored(ramp.range.maximum)));
}

void set_wall(const gl::Program& program, const CavityWall& cavity, const GpuVolume& volume) {
  volume.set_uniforms(program, 2);
  set_tissues(program, volume);
  program.set("section", cavity.section ? 1 : 0);
  program.set("wall_strength", static_cast<float>(cavity.wall.strength));
  program.set("wall_colour", glm::vec3(cavity.wall.colour));
  program.set("wall_deepening", static_cast<float>(cavity.wall.deepening));
  program.set("wall_edge_mm", static_cast<float>(cavity.wall.edge_mm));
  program.set("wall_edge_colour", glm::vec3(cavity.wall.edge_colour));
  program.set("context_limits", volume.to_stored(cavity.context));
  program.set("wall_centre_mm", glm::vec3(cavity.centre_mm));
  program.set("wall_radius_mm", static_cast<float>(cavity.radius_mm));
}

}  // namespace

const gl::Program& ShadePass::program_for(const Variant& variant) {
  const auto known = programs_.find(variant);
  if (known != programs_.end()) return known->second;
  auto definitions = shader_definitions(*variant.model);
  definitions["BRANCH"] = variant.branch == kContext ? "CONTEXT" : "FOCUS";
  definitions["SUPERSAMPLING"] = std::to_string(variant.supersampling);
  if (variant.turns) definitions["TURNS"] = "";
  definitions["RELIEF"] = variant.relief ? "1" : "0";
  definitions["WALL"] = variant.wall ? "1" : "0";
  gl::Program program(shaders_, "rays.vert", "shade.frag", definitions);
  return programs_.emplace(variant, std::move(program)).first->second;
}

void ShadePass::run(const ShadeKey& key, BranchIndex index, const GpuVolume& volume,
                    const BranchBuffers& branch, const gl::Texture2D& surface,
                    const gl::PixelRect& strip, int supersampling,
                    const gl::FullscreenTriangle& triangle) {
  const ShadingModel& model = find_shading_model(key.lit.shading.name);
  const gl::Program& program =
      program_for({&model, index, supersampling, reads_turning(key.lit.shading),
                   key.relief.has_value(), key.wall.has_value()});
  program.use();
  program.set_texture("surface_texture", 0, surface.name());
  program.set("light_direction", key.lit.light_direction);
  set_view_rays(program, key.rays);
  const UniformStruct uniforms(program, model.name, index);
  model.set_parameters(uniforms, key.lit.shading.parameters);
  if (reads_turning(key.lit.shading))
    model.set_turning(uniforms, key.lit.shading.parameters, key.resolution_scale * supersampling);
  if (key.relief) set_relief(program, *key.relief, branch);
  if (key.wall) set_wall(program, *key.wall, volume);
  branch.shade_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
