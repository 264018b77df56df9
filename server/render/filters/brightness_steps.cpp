#include "render/filters/brightness_steps.h"

#include <cmath>

#include "render/parameters.h"

namespace cutaway {

int wide_reach_px(double sigma_px) { return static_cast<int>(std::ceil(2.5 * 1.6 * sigma_px)); }

std::vector<FilterStep> scale_steps(int shader, double sigma_px) {
  const int reach_px = wide_reach_px(sigma_px);
  const int cost = 2 + reach_px;
  return {{.shader = shader, .writes = {kScratch}, .reads = {}, .reach_px = reach_px, .cost = cost},
          {.shader = shader + 1,
           .writes = {kScales},
           .reads = {{"row_sums", kScratch}},
           .reach_px = reach_px,
           .cost = cost}};
}

double length_px(const Json& parameters, const char* name, double resolution_scale) {
  return parameters.at(name).get<double>() * resolution_scale;
}

void offer_ink(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.offer("sigma_px", static_cast<float>(length_px(parameters, "sigma", resolution_scale)));
  program.offer("ink", colour(parameters, "colour"));
  program.offer("strength", number(parameters, "strength"));
}

}  // namespace cutaway
