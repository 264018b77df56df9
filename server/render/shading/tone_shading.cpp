// The flexible tone shader; see shaders/shade_tone.glsl.
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

void set_parameters(const gl::Program& program, const Json& parameters) {
  program.set("dark", colour(parameters, "dark"));
  program.set("light", colour(parameters, "light"));
  program.set("detail", number(parameters, "detail"));
  program.set("terminator", number(parameters, "terminator"));
  program.set("half_lambert", is_choice(parameters, "lambert", "half") ? 1 : 0);
}

}  // namespace

extern const ShadingModel kToneShading{"tone", "shade_tone.glsl", set_parameters};

}  // namespace cutaway
