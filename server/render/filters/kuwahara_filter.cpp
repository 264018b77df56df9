// See kuwahara.frag.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

/// A radius that is on in the viewport stays on in a smaller picture.
int radius_in_picture(const Json& parameters, double resolution_scale) {
  const auto radius_px = parameters.at("radius").get<double>();
  if (radius_px == 0.0) return 0;
  return std::max(1, static_cast<int>(std::lround(radius_px * resolution_scale)));
}

constexpr WorkTexture kColourSums{WorkFormat::rgba32f, 0};
constexpr WorkTexture kWindows{WorkFormat::rgba32f, 1};
constexpr WorkTexture kSquareSums{WorkFormat::r32f, 0};

/// Sums lie a radius further right and down than the pixels they begin at; the first step's are
/// those of whole rows below the region, too. Nothing to sum where nothing is reached.
FilterPlan plan(const Json& parameters, double resolution_scale) {
  const int radius_px = radius_in_picture(parameters, resolution_scale);
  const int cost = 1 + radius_px / 2;
  if (radius_px == 0) return chained({{.shader = 2}});
  const glm::ivec2 rows_px(radius_px, 2 * radius_px);
  const glm::ivec2 windows_px(radius_px);
  return {.steps = {{.shader = 0,
                     .writes = {kColourSums, kSquareSums},
                     .beyond_px = rows_px,
                     .further_px = rows_px,
                     .cost = cost},
                    {.shader = 1,
                     .writes = {kWindows},
                     .reads = {{"colour_sums", kColourSums}, {"square_sums", kSquareSums}},
                     .beyond_px = windows_px,
                     .further_px = windows_px,
                     .cost = cost},
                    {.shader = 2, .reads = {{"windows", kWindows}}}},
          .reach_px = radius_px};
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.set("radius_px", radius_in_picture(parameters, resolution_scale));
}

constexpr std::array kShaders = {"kuwahara_rows.frag", "kuwahara_windows.frag", "kuwahara.frag"};

}  // namespace

extern const ImageFilter kKuwaharaFilter{"kuwahara", kShaders, plan, set_parameters};

}  // namespace cutaway
