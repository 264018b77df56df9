// Move-only owners of GL object names.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace cutaway::gl {

/// Owns one GL name; 0 means none. Create, use and destroy it on the thread whose context is
/// current.
template <void (*Delete)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : name_(name) {}
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (name_ != 0) Delete(name_);
  }

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  GLuint name_ = 0;
};

inline void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void delete_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void delete_query(GLuint name) { glDeleteQueries(1, &name); }
inline void delete_program(GLuint name) { glDeleteProgram(name); }
inline void delete_shader(GLuint name) { glDeleteShader(name); }

using TextureHandle = Handle<delete_texture>;
using BufferHandle = Handle<delete_buffer>;
using FramebufferHandle = Handle<delete_framebuffer>;
using VertexArrayHandle = Handle<delete_vertex_array>;
using QueryHandle = Handle<delete_query>;
using ProgramHandle = Handle<delete_program>;
using ShaderHandle = Handle<delete_shader>;

}  // namespace cutaway::gl
