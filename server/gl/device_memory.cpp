#include "gl/device_memory.h"

#include <epoxy/gl.h>

#include <string>

#include "core/error.h"

namespace cutaway::gl {

bool ran_out_of_memory() { return glGetError() == GL_OUT_OF_MEMORY; }

void throw_if_out_of_memory(const char* what) {
  if (ran_out_of_memory()) throw_out_of_memory(what);
}

void throw_out_of_memory(const char* what) {
  throw Error({.code = ErrorCode::render_failed,
               .message = "the graphics device has no memory left for " + std::string(what),
               .expected = "a smaller picture or volume, or fewer of them"});
}

}  // namespace cutaway::gl
