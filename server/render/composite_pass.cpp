#include "render/composite_pass.h"

namespace cutaway {

CompositePass::CompositePass(const gl::ShaderLibrary& shaders)
    : program_(shaders, "fullscreen.vert", "composite.frag") {}

void CompositePass::run(const Background& background, const gl::Texture2D& context,
                        const gl::Texture2D& focus, const gl::Framebuffer& target,
                        const gl::FullscreenTriangle& triangle) {
  program_.use();
  program_.set_texture("context_colour", 0, context.name());
  program_.set_texture("focus_colour", 1, focus.name());
  program_.set("background_colour", glm::vec3(background.colour));
  target.bind();
  triangle.draw();
}

}  // namespace cutaway
