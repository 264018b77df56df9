#include "render/filters/filter_pass.h"

#include "render/filters/filter_registry.h"

namespace cutaway {

FilterPass::FilterPass(const gl::ShaderLibrary& shaders) {
  for (const ImageFilter& filter : image_filters()) {
    programs_.emplace(filter.name,
                      Entry{&filter, gl::Program(shaders, "fullscreen.vert", filter.shader)});
  }
}

void FilterPass::run(const FilterKey& key, const FilterInput& input, const gl::Framebuffer& target,
                     const gl::PixelRect& strip, const gl::FullscreenTriangle& triangle) const {
  const Entry& entry = programs_.at(key.filter.name);
  const gl::Program& program = entry.program;
  program.use();
  program.set_texture("colour_texture", 0, input.colour.name());
  program.set_texture("silhouette_texture", 1, input.silhouette.name());
  program.set_texture("surface_texture", 2, input.surface.name());
  program.set("is_cut", input.is_cut ? 1 : 0);
  entry.filter->set_parameters(program, key.filter.parameters, key.resolution_scale);
  target.bind(strip);
  triangle.draw();
}

}  // namespace cutaway
