// See depth_gaps.frag.
#include <array>
#include <cmath>

#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

enum Shader { kGaps, kSpecks, kRowsOfLines, kLines };
constexpr std::array kShaders = {"depth_gaps.frag", "depth_specks.frag", "depth_rows.frag",
                                 "depth_lines.frag"};

constexpr WorkTexture kFirst{WorkFormat::rgba32f, 0};
constexpr WorkTexture kSecond{WorkFormat::rgba32f, 1};

float width_in_picture(const Json& parameters, double resolution_scale) {
  return number(parameters, "width") * static_cast<float>(resolution_scale);
}

/// Lines that would lie closer to each other than they are wide are a flight of steps.
int flight_px(const Json& parameters, double resolution_scale) {
  return static_cast<int>(std::ceil(2.0F * width_in_picture(parameters, resolution_scale)));
}

FilterPlan plan(const Json& parameters, double resolution_scale) {
  const float width_px = width_in_picture(parameters, resolution_scale);
  const int reach_px = 1 + static_cast<int>(std::ceil(width_px));  // what an edge's pixel hides
  if (width_px == 0.0F) return chained({{.shader = kLines, .writes = {}, .reads = {}}});
  const int cost = 1 + reach_px / 2;
  return chained({{.shader = kGaps,
                   .writes = {kFirst},
                   .reads = {},
                   .reach_px = 1 + flight_px(parameters, resolution_scale),
                   .cost = 8},
                  {.shader = kSpecks,
                   .writes = {kSecond},
                   .reads = {{"begins", kFirst}},
                   .reach_px = 1,
                   .cost = 3},
                  {.shader = kRowsOfLines,
                   .writes = {kFirst},
                   .reads = {{"begins", kSecond}},
                   .reach_px = reach_px,
                   .cost = cost},
                  {.shader = kLines,
                   .writes = {},
                   .reads = {{"rows", kFirst}},
                   .reach_px = reach_px,
                   .cost = cost}});
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.offer("width_px", width_in_picture(parameters, resolution_scale));
  program.offer("flight_px", flight_px(parameters, resolution_scale));
  program.offer("thinnest", number(parameters, "thinnest"));
  program.offer("gap_mm", number(parameters, "gap_mm"));
  program.offer("full_gap_mm", number(parameters, "full_gap_mm"));
  program.offer("silhouettes", parameters.at("silhouettes").get<bool>() ? 1 : 0);
  program.offer("ink", colour(parameters, "colour"));
  program.offer("strength", number(parameters, "strength"));
}

}  // namespace

extern const ImageFilter kDepthLinesFilter{"depth_lines", kShaders, plan, set_parameters};

}  // namespace cutaway
