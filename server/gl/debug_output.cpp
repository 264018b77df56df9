#include "gl/debug_output.h"

#include <epoxy/gl.h>

#include "core/check.h"
#include "core/log.h"

namespace cutaway::gl {

namespace {

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei,
                           const GLchar* text, const void*) {
  if (type == GL_DEBUG_TYPE_ERROR) check(false, text);
  if (severity == GL_DEBUG_SEVERITY_HIGH) log().warn("OpenGL: {}", text);
}

}  // namespace

void install_debug_output() {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(on_message, nullptr);
}

}  // namespace cutaway::gl
