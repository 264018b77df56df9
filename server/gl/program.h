// Compiled and linked GLSL programs, with uniforms set by name.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>

#include "gl/handle.h"
#include "gl/shader_library.h"
#include "gl/texture.h"

namespace cutaway::gl {

/// A vertex and a fragment shader. Setting a uniform that the linker dropped does nothing; in a
/// debug context setting one that neither shader mentions throws Error "shader-error".
class Program {
 public:
  /// Throws StartUpError (shader_error) with file and line.
  Program(const ShaderLibrary& library, std::string_view vertex, std::string_view fragment,
          const std::map<std::string, std::string>& definitions = {});

  void use() const { glUseProgram(handle_.name()); }

  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, glm::ivec2 value) const;
  void set(const char* name, glm::ivec3 value) const;
  void set(const char* name, const glm::vec2& value) const;
  void set(const char* name, const glm::vec3& value) const;
  void set(const char* name, const glm::mat3& value) const;

  /// The same where the program uses it at all: for what only some of several programs read.
  void offer(const char* name, float value) const;
  void offer(const char* name, int value) const;
  void offer(const char* name, const glm::vec2& value) const;
  void offer(const char* name, const glm::vec3& value) const;

  /// Binds a texture to a unit and a sampler uniform to that unit.
  void set_texture(const char* name, int unit, GLuint texture) const;

 private:
  GLint location(const char* name) const;
  bool uses(const char* name) const;
  void require_mention(const char* name) const;
  ProgramHandle handle_;
  std::string name_;       ///< of the fragment shader
  std::string mentioned_;  ///< both shaders' text, in debug contexts
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace cutaway::gl
