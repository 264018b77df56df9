#include "render/filters/filter_pass.h"

#include "render/filters/filter_registry.h"

namespace cutaway {

FilterPass::FilterPass(const gl::ShaderLibrary& shaders) {
  for (const ImageFilter& filter : image_filters()) {
    programs_.emplace(filter.name,
                      Entry{&filter, gl::Program(shaders, "fullscreen.vert", filter.shader)});
  }
}

void FilterPass::run(const FilterKey& key, const gl::Texture2D& colour,
                     const gl::Texture2D& silhouette, const gl::Framebuffer& target,
                     const gl::FullscreenTriangle& triangle) {
  const Entry& entry = programs_.at(key.filter.name);
  const gl::Program& program = entry.program;
  program.use();
  program.set_texture("colour_texture", 0, colour.name());
  program.set_texture("silhouette_texture", 1, silhouette.name());
  entry.filter->set_parameters(program, key.filter.parameters, key.resolution_scale);
  target.bind();
  triangle.draw();
}

}  // namespace cutaway
