// Phong and Blinn-Phong; see shaders/shade_phong.glsl.
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

void set_parameters(const gl::Program& program, const Json& parameters) {
  program.set("colour", colour(parameters, "colour"));
  program.set("ambient", number(parameters, "ambient"));
  program.set("diffuse", number(parameters, "diffuse"));
  program.set("specular", number(parameters, "specular"));
  program.set("exponent", number(parameters, "exponent"));
  program.set("blinn", is_choice(parameters, "model", "blinn") ? 1 : 0);
}

}  // namespace

extern const ShadingModel kPhongShading{"phong", "shade_phong.glsl", set_parameters};

}  // namespace cutaway
