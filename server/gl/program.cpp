#include "gl/program.h"

#include <regex>
#include <vector>

#include "core/start_up_error.h"

namespace cutaway::gl {

namespace {

[[noreturn]] void throw_shader_error(std::string_view name, const std::string& words) {
  throw StartUpError(StartUpError::Fault::shader_error, words + " (" + std::string(name) + ")");
}

std::string shader_log(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, text.data());
  return text;
}

bool is_debug_context() {
  GLint flags = 0;
  glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
  return (flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
}

ShaderHandle compile(GLenum stage, std::string_view name, const ExpandedShader& expanded) {
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
    : handle_(glCreateProgram()), name_(fragment) {
  const ExpandedShader vertex_text = library.expand(vertex, definitions);
  const ExpandedShader fragment_text = library.expand(fragment, definitions);
  if (is_debug_context()) mentioned_ = vertex_text.text + fragment_text.text;
  const ShaderHandle vertex_shader = compile(GL_VERTEX_SHADER, vertex, vertex_text);
  const ShaderHandle fragment_shader = compile(GL_FRAGMENT_SHADER, fragment, fragment_text);
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
  const GLint found = glGetUniformLocation(handle_.name(), name);
  if (found < 0) require_mention(name);
  return locations_[name] = found;
}

// "tone[1].detail" is mentioned where both tone and detail are.
void Program::require_mention(const char* name) const {
  if (mentioned_.empty()) return;
  static const std::regex word(R"([A-Za-z_]\w*)");
  const std::string text(name);
  for (std::sregex_iterator part(text.begin(), text.end(), word), end; part != end; ++part) {
    if (std::regex_search(mentioned_, std::regex("\\b" + part->str() + "\\b"))) continue;
    throw_shader_error(name_, "no shader declares the uniform " + text);
  }
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

void Program::offer(const char* name, float value) const {
  if (uses(name)) set(name, value);
}
void Program::offer(const char* name, int value) const {
  if (uses(name)) set(name, value);
}
void Program::offer(const char* name, const glm::vec2& value) const {
  if (uses(name)) set(name, value);
}
void Program::offer(const char* name, const glm::vec3& value) const {
  if (uses(name)) set(name, value);
}

bool Program::uses(const char* name) const {
  const auto known = locations_.find(name);
  if (known == locations_.end())
    return (locations_[name] = glGetUniformLocation(handle_.name(), name)) >= 0;
  return known->second >= 0;
}

void Program::set_texture(const char* name, int unit, GLuint texture) const {
  glBindTextureUnit(static_cast<GLuint>(unit), texture);
  set(name, unit);
}

}  // namespace cutaway::gl
