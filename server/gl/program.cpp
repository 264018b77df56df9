#include "gl/program.h"

#include <vector>

#include "core/error.h"

namespace cutaway::gl {

namespace {

[[noreturn]] void throw_shader_error(std::string_view name, const std::string& words) {
  throw Error({.code = "shader-error", .message = words, .field = std::string(name)});
}

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, text.data());
  return text;
}

ShaderHandle compile(const ShaderLibrary& library, GLenum stage, std::string_view name,
                     const std::map<std::string, std::string>& definitions) {
  const ExpandedShader expanded = library.expand(name, definitions);
  ShaderHandle shader(glCreateShader(stage));
  const char* text = expanded.text.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint ok = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &ok);
  if (ok != GL_TRUE)
    throw_shader_error(name, name_files_in_log(shader_log(shader.name()), expanded.file_names));
  return shader;
}

std::string program_log(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program, length, nullptr, text.data());
  return text;
}

}  // namespace

Program::Program(const ShaderLibrary& library, std::string_view vertex, std::string_view fragment,
                 const std::map<std::string, std::string>& definitions)
    : handle_(glCreateProgram()) {
  const ShaderHandle vertex_shader = compile(library, GL_VERTEX_SHADER, vertex, definitions);
  const ShaderHandle fragment_shader = compile(library, GL_FRAGMENT_SHADER, fragment, definitions);
  glAttachShader(handle_.name(), vertex_shader.name());
  glAttachShader(handle_.name(), fragment_shader.name());
  glLinkProgram(handle_.name());
  GLint ok = GL_FALSE;
  glGetProgramiv(handle_.name(), GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) throw_shader_error(fragment, program_log(handle_.name()));
}

GLint Program::location(const char* name) const {
  const auto known = locations_.find(name);
  if (known != locations_.end()) return known->second;
  return locations_[name] = glGetUniformLocation(handle_.name(), name);
}

void Program::set(const char* name, int value) const {
  glProgramUniform1i(handle_.name(), location(name), value);
}
void Program::set(const char* name, float value) const {
  glProgramUniform1f(handle_.name(), location(name), value);
}
void Program::set(const char* name, glm::ivec2 value) const {
  glProgramUniform2i(handle_.name(), location(name), value.x, value.y);
}
void Program::set(const char* name, glm::ivec3 value) const {
  glProgramUniform3i(handle_.name(), location(name), value.x, value.y, value.z);
}
void Program::set(const char* name, const glm::vec2& value) const {
  glProgramUniform2f(handle_.name(), location(name), value.x, value.y);
}
void Program::set(const char* name, const glm::vec3& value) const {
  glProgramUniform3f(handle_.name(), location(name), value.x, value.y, value.z);
}
void Program::set(const char* name, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(handle_.name(), location(name), 1, GL_FALSE, &value[0][0]);
}

void Program::set_texture(const char* name, int unit, GLuint texture) const {
  glBindTextureUnit(static_cast<GLuint>(unit), texture);
  set(name, unit);
}

}  // namespace cutaway::gl
