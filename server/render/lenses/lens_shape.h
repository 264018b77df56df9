// The region in which the focus is drawn.
#pragma once

#include "gl/program.h"
#include "scene/scene.h"

namespace cutaway {

/// One registry entry: a GLSL file that defines `lens_interval`, `lens_normal` and
/// `lens_offset` (see shaders/lens_sphere.glsl), and how its uniforms follow from the lens.
struct LensShape {
  const char* name;
  const char* shader;
  void (*set_parameters)(const gl::Program& program, const Lens& lens);
};

}  // namespace cutaway
