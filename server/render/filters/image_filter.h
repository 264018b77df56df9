// A change of one branch's picture after shading and before the composite.
#pragma once

#include <span>

#include "gl/program.h"
#include "scene/json.h"

namespace cutaway {

/// One registry entry: fragment shaders over filter.glsl, drawn one after the other, and
/// how their uniforms follow from the module's parameters. `resolution_scale` is picture pixels per
/// viewport pixel: lengths in px are the viewport's.
struct ImageFilter {
  const char* name;
  /// The last one draws the picture; those before it draw what FilterSums holds, in their order.
  std::span<const char* const> shaders;
  void (*set_parameters)(const gl::Program& program, const Json& parameters,
                         double resolution_scale);
  /// How far the shaders before the last draw beyond the picture, px.
  int (*reach_px)(const Json& parameters, double resolution_scale);
};

}  // namespace cutaway
