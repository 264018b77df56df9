#include "render/composite_pass.h"

#include "render/lenses/lens_registry.h"

namespace cutaway {

CompositePass::CompositePass(const gl::ShaderLibrary& shaders)
    : plain_(shaders, "fullscreen.vert", "composite.frag") {
  for (const LensShape& shape : lens_shapes()) {
    magic_.emplace(shape.name,
                   Entry{&shape, gl::Program(shaders, "rays.vert", "composite_magic.frag",
                                             shader_definitions(shape))});
  }
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
  const Entry& entry = magic_.at(lens.shape.name);
  entry.program.set("lens_strength", static_cast<float>(lens.strength));
  entry.program.set("lens_softness", static_cast<float>(lens.softness));
  entry.program.set("lens_strict", lens.strict ? 1 : 0);
  entry.shape->set_parameters(entry.program, lens);
  set_view_rays(entry.program, key.magic->rays);
  return entry.program;
}

}  // namespace cutaway
