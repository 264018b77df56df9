// Lines and ink from the difference of two Gaussians; see dog.frag and xdog.frag.
#include <array>

#include "render/filters/brightness_steps.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

FilterPlan plan(const Json& parameters, double resolution_scale) {
  const double sigma_px = length_px(parameters, "sigma", resolution_scale);
  FilterStep last{.shader = 2, .writes = {}, .reads = {}};
  if (sigma_px == 0.0) return chained({std::move(last)});
  std::vector<FilterStep> steps = scale_steps(0, sigma_px);
  last.reads = {{"scales", kScales}};
  steps.push_back(std::move(last));
  return chained(std::move(steps));
}

void set_dog(const gl::Program& program, const Json& parameters, double resolution_scale) {
  offer_ink(program, parameters, resolution_scale);
  program.offer("tau", number(parameters, "tau"));
  program.offer("threshold", number(parameters, "threshold"));
}

void set_xdog(const gl::Program& program, const Json& parameters, double resolution_scale) {
  offer_ink(program, parameters, resolution_scale);
  program.offer("edges", number(parameters, "edges"));
  program.offer("threshold", number(parameters, "threshold"));
  program.offer("hardness", number(parameters, "hardness"));
}

constexpr std::array kDogShaders = {"brightness_rows.frag", "brightness_columns.frag", "dog.frag"};
constexpr std::array kXdogShaders = {"brightness_rows.frag", "brightness_columns.frag",
                                     "xdog.frag"};

}  // namespace

extern const ImageFilter kDogFilter{"dog", kDogShaders, plan, set_dog};
extern const ImageFilter kXdogFilter{"xdog", kXdogShaders, plan, set_xdog};

}  // namespace cutaway
