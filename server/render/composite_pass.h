// Fourth stage: the branches over the background.
#pragma once

#include <map>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/view_rays.h"
#include "scene/scene.h"

namespace cutaway {

/// The Magic Lens' region, from which the focus' weight at each pixel follows.
struct MagicLens {
  Lens lens;
  ViewRays rays{};
  bool operator==(const MagicLens&) const = default;
};

struct CompositeKey {
  std::uint64_t context_version = 0;
  std::uint64_t focus_version = 0;
  const gl::Texture2D* context_texture = nullptr;  ///< which of a branch's targets is its last
  const gl::Texture2D* focus_texture = nullptr;
  Background background;
  std::optional<MagicLens> magic;
  bool operator==(const CompositeKey&) const = default;
};

/// Lens weights are applied here and never before the filters, which would take a fade for an edge.
class CompositePass {
 public:
  explicit CompositePass(const gl::ShaderLibrary& shaders);
  void run(const CompositeKey& key, const gl::Framebuffer& target, const gl::PixelRect& strip,
           const gl::FullscreenTriangle& triangle) const;

 private:
  const gl::Program& prepared(const CompositeKey& key) const;

  gl::Program plain_;
  std::map<std::string, gl::Program, std::less<>> magic_;  ///< by the lens' body
};

}  // namespace cutaway
