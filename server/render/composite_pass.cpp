#include "render/composite_pass.h"

#include "render/lens_uniforms.h"

namespace cutaway {

CompositePass::CompositePass(const gl::ShaderLibrary& shaders)
    : plain_(shaders, "fullscreen.vert", "composite.frag") {
  for (const std::string& body : lens_body_files())
    magic_.emplace(
        body, gl::Program(shaders, "rays.vert", "composite_magic.frag", lens_definitions(body)));
}

void CompositePass::run(const CompositeKey& key, const gl::Framebuffer& target,
                        const gl::PixelRect& strip, const gl::FullscreenTriangle& triangle) const {
  const gl::Program& program = prepared(key);
  program.use();
  program.set_texture("context_colour", 0, key.context_texture->name());
  program.set_texture("focus_colour", 1, key.focus_texture->name());
  program.set("background_colour", glm::vec3(key.background.colour));
  target.bind(strip);
  triangle.draw();
}

const gl::Program& CompositePass::prepared(const CompositeKey& key) const {
  if (!key.magic) return plain_;
  const Lens& lens = key.magic->lens;
  const gl::Program& program = magic_.at(lens_body_file(lens));
  program.set("lens_strength", static_cast<float>(lens.strength));
  program.set("lens_softness", static_cast<float>(lens.softness));
  program.set("lens_strict", lens.strict ? 1 : 0);
  set_lens_body(program, lens);
  set_view_rays(program, key.magic->rays);
  return program;
}

}  // namespace cutaway
