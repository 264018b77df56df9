// The GLSL files, embedded at build, and those made from the registries.
#pragma once

#include <span>

#include "core/embedded_file.h"
#include "gl/shader_library.h"

namespace cutaway {

std::span<const EmbeddedFile> embedded_shaders();

/// All that the passes compile from.
gl::ShaderLibrary shader_library();

}  // namespace cutaway
