// See shaders/filter_kuwahara.frag.
#include <algorithm>
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

void set_parameters(const gl::Program& program, const Json& parameters, double resolution_scale) {
  program.set("radius_px", radius_in_picture(parameters.at("radius").get<int>(), resolution_scale));
}

}  // namespace

extern const ImageFilter kKuwaharaFilter{"kuwahara", "filter_kuwahara.frag", set_parameters};

}  // namespace cutaway
