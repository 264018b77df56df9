// The GLSL files of this folder, embedded at build.
#pragma once

#include <span>

#include "core/embedded_file.h"

namespace cutaway {

std::span<const EmbeddedFile> embedded_shaders();

}  // namespace cutaway
