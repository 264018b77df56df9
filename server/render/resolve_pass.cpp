#include "render/resolve_pass.h"

namespace cutaway {

ResolvePass::ResolvePass(const gl::ShaderLibrary& shaders)
    : program_(shaders, "fullscreen.vert", "resolve.frag") {}

void ResolvePass::run(const BranchBuffers& branch, const gl::PixelRect& strip, int supersampling,
                      const gl::FullscreenTriangle& triangle) const {
  program_.use();
  program_.set_texture("surface_texture", 0, branch.surface.name());
  program_.set_texture("layers_texture", 1, branch.layers.name());
  program_.set("supersampling", supersampling);
  branch.shade_target.bind(strip);
  const gl::DepthTest test(gl::DepthTest::over_drawn);
  triangle.draw();
}

}  // namespace cutaway
