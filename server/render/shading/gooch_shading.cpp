// Gooch's warm-to-cool shading; see gooch.glsl.
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

void set_parameters(const UniformStruct& uniforms, const Json& parameters) {
  uniforms.set("colour", colour(parameters, "colour"));
  uniforms.set("blue", number(parameters, "blue"));
  uniforms.set("yellow", number(parameters, "yellow"));
  uniforms.set("alpha", number(parameters, "alpha"));
  uniforms.set("beta", number(parameters, "beta"));
}

}  // namespace

extern const ShadingModel kGoochShading{"gooch", "gooch.glsl", set_parameters};

}  // namespace cutaway
