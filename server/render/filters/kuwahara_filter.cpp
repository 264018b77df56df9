// See kuwahara.frag.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

/// A radius that is on in the viewport stays on in a smaller picture.
int radius_in_picture(int radius_px, double resolution_scale) {
  if (radius_px == 0) return 0;
  return std::max(1, static_cast<int>(std::lround(radius_px * resolution_scale)));
}

int reach_px(const Json& parameters, double resolution_scale) {
  return radius_in_picture(parameters.at("radius").get<int>(), resolution_scale);
}

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.set("radius_px", reach_px(parameters, resolution_scale));
}

constexpr std::array kShaders = {"kuwahara_rows.frag", "kuwahara_windows.frag", "kuwahara.frag"};

}  // namespace

extern const ImageFilter kKuwaharaFilter{"kuwahara", kShaders, set_parameters, reach_px};

}  // namespace cutaway
