// A change of one branch's picture after shading and before the composite.
#pragma once

#include "gl/program.h"
#include "scene/json.h"

namespace cutaway {

/// One registry entry: a fragment shader over shaders/filter.glsl, and how its uniforms follow from
/// the module's parameters. `resolution_scale` is picture pixels per viewport pixel: lengths in px
/// are the viewport's.
struct ImageFilter {
  const char* name;
  const char* shader;
  void (*set_parameters)(const gl::Program& program, const Json& parameters,
                         double resolution_scale);
};

}  // namespace cutaway
