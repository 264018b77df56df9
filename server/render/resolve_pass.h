// Second stage where rays pass through translucent material: accumulated layers into a picture.
#pragma once

#include "gl/program.h"
#include "render/view_buffers.h"

namespace cutaway {

class ResolvePass {
 public:
  explicit ResolvePass(const gl::ShaderLibrary& shaders);
  void run(const BranchBuffers& branch, const gl::PixelRect& strip, int supersampling,
           const gl::FullscreenTriangle& triangle) const;

 private:
  gl::Program program_;
};

}  // namespace cutaway
