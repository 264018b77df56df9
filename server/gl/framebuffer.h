// Drawing into textures, and the one primitive that every pass draws.
#pragma once

#include <initializer_list>

#include "gl/texture.h"

namespace cutaway::gl {

/// Colour attachments 0.. in the order given, all of one size. The textures must outlive it.
class Framebuffer {
 public:
  Framebuffer() = default;
  explicit Framebuffer(std::initializer_list<const Texture2D*> attachments);

  GLuint name() const { return handle_.name(); }

  /// Binds it for drawing, with a viewport of its whole size.
  void bind() const;

 private:
  FramebufferHandle handle_;
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
