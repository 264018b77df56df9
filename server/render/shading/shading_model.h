// How one sample of a surface gets its colour.
#pragma once

#include "gl/program.h"
#include "scene/json.h"

namespace cutaway {

/// One registry entry: a GLSL file that defines `vec3 shade(vec3 normal, vec3 to_viewer)`, and how
/// its uniforms follow from the module's parameters (checked and complete, as their schema entry
/// says).
struct ShadingModel {
  const char* name;
  const char* shader;
  void (*set_parameters)(const gl::Program& program, const Json& parameters);
};

}  // namespace cutaway
