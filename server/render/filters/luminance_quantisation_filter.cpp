// See luminance_quantisation.frag.
#include <array>

#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

FilterPlan plan(const Json& /*parameters*/, double /*resolution_scale*/) {
  return chained({{.shader = 0, .writes = {}, .reads = {}}});
}

void set_parameters(const gl::Program& program, const Json& parameters, double) {
  program.set("bins", parameters.at("bins").get<int>());
  program.set("hardness", number(parameters, "hardness"));
}

constexpr std::array kShaders = {"luminance_quantisation.frag"};

}  // namespace

extern const ImageFilter kLuminanceQuantisationFilter{"luminance_quantisation", kShaders, plan,
                                                      set_parameters};

}  // namespace cutaway
