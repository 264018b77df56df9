// Fourth stage: the branches over the background.
#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "scene/scene.h"

namespace cutaway {

struct CompositeKey {
  std::uint64_t context_version = 0;
  std::uint64_t focus_version = 0;
  const void* context_texture = nullptr;  ///< which of a branch's targets is its last
  const void* focus_texture = nullptr;
  Background background;
  bool operator==(const CompositeKey&) const = default;
};

class CompositePass {
 public:
  explicit CompositePass(const gl::ShaderLibrary& shaders);
  void run(const Background& background, const gl::Texture2D& context, const gl::Texture2D& focus,
           const gl::Framebuffer& target, const gl::FullscreenTriangle& triangle);

 private:
  gl::Program program_;
};

}  // namespace cutaway
