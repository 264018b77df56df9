#include "gl/framebuffer.h"

#include <vector>

#include "core/check.h"

namespace cutaway::gl {

Framebuffer::Framebuffer(std::span<const Texture2D* const> attachments, const Texture2D* depth) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  handle_ = FramebufferHandle(name);
  std::vector<GLenum> buffers;
  for (const Texture2D* texture : attachments) {
    const GLenum point = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
    glNamedFramebufferTexture(name, point, texture->name(), 0);
    buffers.push_back(point);
    size_px_ = texture->size_px();
  }
  if (depth != nullptr) glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->name(), 0);
  glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(buffers.size()), buffers.data());
  check_equal(glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER),
              GLenum{GL_FRAMEBUFFER_COMPLETE}, "framebuffer is complete");
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, handle_.name());
  glViewport(0, 0, size_px_.x, size_px_.y);
  glDisable(GL_SCISSOR_TEST);
}

void Framebuffer::bind(const PixelRect& region) const {
  bind();
  const glm::ivec2 size = glm::max(region.end - region.begin, glm::ivec2(0));
  glEnable(GL_SCISSOR_TEST);
  glScissor(region.begin.x, region.begin.y, size.x, size.y);
}

void Framebuffer::clear(std::initializer_list<glm::vec4> values) const {
  bind();
  GLint attachment = 0;
  for (const glm::vec4& value : values) glClearBufferfv(GL_COLOR, attachment++, &value[0]);
}

DepthTest::DepthTest(Rule rule) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(rule == keep_nearest ? GL_LESS : GL_GREATER);
  glDepthMask(rule == keep_nearest ? GL_TRUE : GL_FALSE);
}

DepthTest::~DepthTest() {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
}

FullscreenTriangle::FullscreenTriangle() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  vertex_array_ = VertexArrayHandle(name);
}

void FullscreenTriangle::draw() const {
  glBindVertexArray(vertex_array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace cutaway::gl
