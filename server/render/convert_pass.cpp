#include "render/convert_pass.h"

namespace cutaway {

ConvertPass::ConvertPass(const gl::ShaderLibrary& shaders)
    : luma_(shaders, "fullscreen.vert", "convert_luma.frag"),
      halved_chroma_(shaders, "fullscreen.vert", "convert_chroma.frag", {{"BLOCK_PX", "2"}}),
      full_chroma_(shaders, "fullscreen.vert", "convert_chroma.frag", {{"BLOCK_PX", "1"}}) {}

void ConvertPass::run(PixelLayout layout, const ViewBuffers& buffers,
                      const gl::FullscreenTriangle& triangle) {
  luma_.use();
  luma_.set_texture("picture", 0, buffers.picture.texture.name());
  buffers.luma.framebuffer.bind();
  triangle.draw();

  const gl::Program& chroma = layout == PixelLayout::yuv420 ? halved_chroma_ : full_chroma_;
  chroma.use();
  chroma.set_texture("picture", 0, buffers.picture.texture.name());
  buffers.chroma_target.bind();
  triangle.draw();
}

std::vector<gl::PixelReadback::Source> readback_sources(PixelLayout layout,
                                                        const ViewBuffers& buffers) {
  const std::vector<PlaneShape> shapes = plane_shapes(layout, buffers.picture_size_px());
  const auto source = [&](std::size_t plane, const gl::Framebuffer& framebuffer, int attachment) {
    return gl::PixelReadback::Source{&framebuffer, shapes[plane].size_px, attachment,
                                     shapes[plane].bytes_per_pixel};
  };
  if (layout == PixelLayout::rgba) return {source(0, buffers.picture.framebuffer, 0)};
  return {source(0, buffers.luma.framebuffer, 0), source(1, buffers.chroma_target, 0),
          source(2, buffers.chroma_target, 1)};
}

}  // namespace cutaway
