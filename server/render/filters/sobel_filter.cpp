// See shaders/filter_sobel.frag.
#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

int mode_number(const Json& parameters) {
  if (is_choice(parameters, "mode", "darken")) return 0;
  return is_choice(parameters, "mode", "brighten") ? 1 : 2;
}

void set_parameters(const gl::Program& program, const Json& parameters, double) {
  program.set("strength", number(parameters, "strength"));
  program.set("mode", mode_number(parameters));
  program.set("gain", is_choice(parameters, "norm", "raw") ? 1.0F : 0.25F);
  program.set("euclidean", is_choice(parameters, "gradient", "l2") ? 1 : 0);
}

}  // namespace

extern const ImageFilter kSobelFilter{"sobel", "filter_sobel.frag", set_parameters};

}  // namespace cutaway
