// The flexible tone shader; see tone.glsl.
#include <algorithm>

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

/// At least from one ray to the next: a narrower step would have stairs again.
void set_softness(const UniformStruct& uniforms, const Json& parameters, double rays_a_pixel) {
  uniforms.set("softness_rays",
               std::max(1.0F, number(parameters, "softness") * static_cast<float>(rays_a_pixel)));
}

bool is_soft(const Json& parameters) { return number(parameters, "softness") > 0.0F; }

}  // namespace

extern const ShadingModel kToneShading{"tone", "tone.glsl", set_parameters, is_soft, set_softness};

}  // namespace cutaway
