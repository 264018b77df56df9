// Phong and Blinn-Phong; see phong.glsl.
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

void set_parameters(const UniformStruct& uniforms, const Json& parameters) {
  uniforms.set("colour", colour(parameters, "colour"));
  uniforms.set("ambient", number(parameters, "ambient"));
  uniforms.set("diffuse", number(parameters, "diffuse"));
  uniforms.set("specular", number(parameters, "specular"));
  uniforms.set("exponent", number(parameters, "exponent"));
  uniforms.set("blinn", is_choice(parameters, "model", "blinn") ? 1 : 0);
}

}  // namespace

extern const ShadingModel kPhongShading{"phong", "phong.glsl", set_parameters};

}  // namespace cutaway
