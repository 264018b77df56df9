// The flexible tone shader; see tone.glsl.
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

void set_parameters(const UniformStruct& uniforms, const Json& parameters) {
  uniforms.set("dark", colour(parameters, "dark"));
  uniforms.set("light", colour(parameters, "light"));
  uniforms.set("detail", number(parameters, "detail"));
  uniforms.set("terminator", number(parameters, "terminator"));
  uniforms.set("half_lambert", is_choice(parameters, "lambert", "half") ? 1 : 0);
}

}  // namespace

extern const ShadingModel kToneShading{"tone", "tone.glsl", set_parameters};

}  // namespace cutaway
