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
  if (layout == PixelLayout::rgba) {
    return {{&buffers.picture.framebuffer, buffers.picture_size_px(), 0, GL_RGBA, 4}};
  }
  const glm::ivec2 chroma_size_px = buffers.chroma_size_px(layout);
  return {{&buffers.luma.framebuffer, buffers.luma_size_px(layout), 0, GL_RED, 1},
          {&buffers.chroma_target, chroma_size_px, 0, GL_RED, 1},
          {&buffers.chroma_target, chroma_size_px, 1, GL_RED, 1}};
}

}  // namespace cutaway
