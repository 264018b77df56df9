// The ramp of six colours; see ramp.glsl.
#include <array>
#include <string>

#include "core/colour.h"
#include "render/parameters.h"
#include "render/shading/shading_model.h"

namespace cutaway {

namespace {

constexpr std::array kStops = {"deepest", "deep", "middle", "light", "lighter", "lightest"};
constexpr int kColours = 81;  ///< RAMP_COLOURS of the shader; the six lie on them

glm::dvec3 colour_at(const Json& parameters, double share) {
  const double at = share * (kStops.size() - 1);
  const auto below = std::min<std::size_t>(static_cast<std::size_t>(at), kStops.size() - 2);
  return mix_colours(colour(parameters, kStops[below]), colour(parameters, kStops[below + 1]),
                     at - static_cast<double>(below));
}

void set_parameters(const UniformStruct& uniforms, const Json& parameters) {
  for (int i = 0; i < kColours; ++i)
    uniforms.set(("colours[" + std::to_string(i) + "]").c_str(),
                 glm::vec3(colour_at(parameters, double(i) / (kColours - 1))));
  uniforms.set("gamma", number(parameters, "gamma"));
  uniforms.set("step_share", number(parameters, "step"));
  const float half_width = number(parameters, "step_width") / 2.0F;
  uniforms.set("step_begin", number(parameters, "step_at") - half_width);
  uniforms.set("step_end", number(parameters, "step_at") + half_width);
}

}  // namespace

extern const ShadingModel kRampShading{"ramp", "ramp.glsl", set_parameters};

}  // namespace cutaway
