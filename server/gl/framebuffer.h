// Drawing into textures, and the one primitive that every pass draws.
#pragma once

#include <initializer_list>
#include <span>

#include "core/pixel_rect.h"
#include "gl/texture.h"

namespace cutaway::gl {

using cutaway::PixelRect;

/// Depths as GL counts them.
inline constexpr float kNearest = 0.0F;
inline constexpr float kFarthest = 1.0F;

/// Colour attachments 0.. in the order given, all of one size. The textures must outlive it.
class Framebuffer {
 public:
  Framebuffer() = default;
  /// `depth`: the depth attachment, if there is to be one.
  explicit Framebuffer(std::span<const Texture2D* const> attachments,
                       const Texture2D* depth = nullptr);
  explicit Framebuffer(std::initializer_list<const Texture2D*> attachments,
                       const Texture2D* depth = nullptr)
      : Framebuffer(std::span(attachments.begin(), attachments.size()), depth) {}

  GLuint name() const { return handle_.name(); }

  /// Binds it for drawing, with a viewport of its whole size.
  void bind() const;
  /// The same, but nothing is drawn outside of `region`.
  void bind(const PixelRect& region) const;
  /// Sets every pixel of the first colour attachments, to a value each.
  void clear(std::initializer_list<glm::vec4> values) const;
  /// Of the framebuffer that is bound.
  static void clear_depth(float depth) { glClearBufferfv(GL_DEPTH, 0, &depth); }

 private:
  FramebufferHandle handle_;
  glm::ivec2 size_px_{0};
};

/// A depth test for as long as it lives; without one nothing is tested.
class DepthTest {
 public:
  enum Rule {
    keep_nearest,  ///< draws what is nearest, and its depth
    over_drawn     ///< draws only where something nearer than the farthest was drawn before
  };
  explicit DepthTest(Rule rule);
  ~DepthTest();
  DepthTest(const DepthTest&) = delete;
  DepthTest& operator=(const DepthTest&) = delete;
};

/// One triangle that covers the viewport at the farthest depth; the vertex shader makes its corners
/// from gl_VertexID.
class FullscreenTriangle {
 public:
  FullscreenTriangle();
  void draw() const;

 private:
  VertexArrayHandle vertex_array_;
};

}  // namespace cutaway::gl
