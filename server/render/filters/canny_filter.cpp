// See canny_crests.frag.
#include <array>
#include <cmath>

#include "render/filters/brightness_steps.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

enum Shader { kRows, kColumns, kCrests, kFollow, kLines };
constexpr std::array kShaders = {"brightness_rows.frag", "brightness_columns.frag",
                                 "canny_crests.frag", "canny_follow.frag", "canny.frag"};

constexpr std::array kEdges = {WorkTexture{WorkFormat::r32f, 0}, WorkTexture{WorkFormat::r32f, 1}};

/// A weak edge is followed a pixel at a time: the trail's length is the bound of how often.
FilterPlan plan(const Json& parameters, double resolution_scale) {
  const double sigma_px = length_px(parameters, "sigma", resolution_scale);
  if (sigma_px == 0.0) return chained({{.shader = kLines, .writes = {}, .reads = {}}});
  const auto trail_px =
      static_cast<int>(std::lround(length_px(parameters, "trail", resolution_scale)));
  std::vector<FilterStep> steps = scale_steps(kRows, sigma_px);
  steps.push_back({.shader = kCrests,
                   .writes = {kEdges[0]},
                   .reads = {{"scales", kScales}},
                   .reach_px = 2,
                   .cost = 6});
  for (int i = 0; i < trail_px; ++i)
    steps.push_back({.shader = kFollow,
                     .writes = {kEdges[(i + 1) % 2]},
                     .reads = {{"edges", kEdges[i % 2]}},
                     .reach_px = 1});
  steps.push_back({.shader = kLines, .writes = {}, .reads = {{"edges", kEdges[trail_px % 2]}}});
  return chained(std::move(steps));
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  offer_ink(program, parameters, resolution_scale);
  program.offer("high", number(parameters, "high"));
  program.offer("low", number(parameters, "low"));
}

}  // namespace

extern const ImageFilter kCannyFilter{"canny", kShaders, plan, set_parameters};

}  // namespace cutaway
