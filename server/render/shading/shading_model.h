// How one point of a surface gets its colour.
#pragma once

#include "render/uniform_struct.h"
#include "scene/json.h"

namespace cutaway {

/// One registry entry. `shader` is a GLSL file that defines `vec3 shade_NAME(int branch, vec3
/// normal, vec3 to_viewer, float light_share)`, the last being what no shadow takes of the light,
/// over `light_direction` and over `uniform STRUCT NAME[2]`, its parameters by branch;
/// `set_parameters` fills one of the two from the module's parameters (checked and complete, as
/// their schema entry says; lengths in pixels).
///
/// A model that may want to know how the normal turns about a point has `reads_turning`, which says
/// whether its parameters ask for that, `set_turning`, which sets what only that reads (pixels are
/// the viewport's; `rays_a_pixel` each way), and in its shader a function `shade_NAME_turning` with
/// one argument more: how the normal changes to the next ray, across and down.
struct ShadingModel {
  const char* name;
  const char* shader;
  void (*set_parameters)(const UniformStruct& uniforms, const Json& parameters);
  bool (*reads_turning)(const Json& parameters) = nullptr;
  void (*set_turning)(const UniformStruct& uniforms, const Json& parameters,
                      double rays_a_pixel) = nullptr;
};

}  // namespace cutaway
