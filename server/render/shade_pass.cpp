#include "render/shade_pass.h"

#include "render/shading/shading_registry.h"

namespace cutaway {

ShadePass::ShadePass(const gl::ShaderLibrary& shaders)
    : program_(shaders, "fullscreen.vert", "shade.frag") {}

void ShadePass::run(const ShadeKey& key, BranchIndex index, const BranchBuffers& branch,
                    int supersampling, const gl::FullscreenTriangle& triangle) const {
  program_.use();
  program_.set_texture("surface_texture", 0, branch.surface.name());
  program_.set("branch", static_cast<int>(index));
  program_.set("supersampling", supersampling);
  program_.set("light_direction", key.look.light_direction);
  set_view_rays(program_, key.rays);
  set_shading(program_, index, key.look.shading);
  branch.shade_target.bind();
  triangle.draw();
}

}  // namespace cutaway
