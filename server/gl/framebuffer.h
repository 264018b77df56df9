// Drawing into textures, and the one primitive that every pass draws.
#pragma once

#include <initializer_list>

#include "gl/texture.h"

namespace cutaway::gl {

/// Pixels [begin, end), row 0 first in memory.
struct PixelRect {
  glm::ivec2 begin{0};
  glm::ivec2 end{0};
  bool is_empty() const { return end.x <= begin.x || end.y <= begin.y; }
  bool operator==(const PixelRect&) const = default;
};

/// Colour attachments 0.. in the order given, all of one size. The textures must outlive it.
class Framebuffer {
 public:
  Framebuffer() = default;
  explicit Framebuffer(std::initializer_list<const Texture2D*> attachments);

  GLuint name() const { return handle_.name(); }

  /// Binds it for drawing, with a viewport of its whole size.
  void bind() const;
  /// The same, but nothing is drawn outside of `region`.
  void bind(const PixelRect& region) const;
  /// Sets every pixel of every attachment.
  void clear(const glm::vec4& value) const;
  glm::ivec2 size_px() const { return size_px_; }

 private:
  FramebufferHandle handle_;
  int attachments_ = 0;
  glm::ivec2 size_px_{0};
};

/// One triangle that covers the viewport; the vertex shader makes its corners from gl_VertexID.
class FullscreenTriangle {
 public:
  FullscreenTriangle();
  void draw() const;

 private:
  VertexArrayHandle vertex_array_;
};

}  // namespace cutaway::gl
