// Fifth stage: the picture into the planes that JPEG compresses.
#pragma once

#include "gl/framebuffer.h"
#include "gl/pixel_readback.h"
#include "gl/program.h"
#include "render/view_buffers.h"

namespace cutaway {

/// All that the planes depend on.
struct ConvertKey {
  std::uint64_t picture_version = 0;  ///< of the composite
  PixelLayout layout = PixelLayout::yuv420;
  bool operator==(const ConvertKey&) const = default;
};

class ConvertPass {
 public:
  explicit ConvertPass(const gl::ShaderLibrary& shaders);
  /// Fills the planes of `layout`, a YCbCr one.
  void run(PixelLayout layout, const ViewBuffers& buffers, const gl::FullscreenTriangle& triangle);

 private:
  gl::Program luma_;
  gl::Program halved_chroma_;
  gl::Program full_chroma_;
};

/// Where a layout's pixels lie once they are converted, in the order of plane_shapes.
std::vector<gl::PixelReadback::Source> readback_sources(PixelLayout layout,
                                                        const ViewBuffers& buffers);

}  // namespace cutaway
