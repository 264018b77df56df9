// See sobel.frag.
#include <algorithm>
#include <array>
#include <string_view>

#include "core/check.h"
#include "render/filters/image_filter.h"
#include "render/parameters.h"

namespace cutaway {

namespace {

/// In the order of the shader's numbers.
constexpr std::array<std::string_view, 3> kModes = {"darken", "brighten", "multiply"};
constexpr std::array<std::string_view, 4> kSources = {"colour", "luma", "depth", "normal"};

template <std::size_t Count>
int number_of(const std::array<std::string_view, Count>& names, const Json& name) {
  const auto found = std::ranges::find(names, name.get_ref<const std::string&>());
  check(found != names.end(), "a choice that the schema does not know");
  return static_cast<int>(found - names.begin());
}

void set_parameters(const gl::Program& program, const Json& parameters, double) {
  program.set("strength", number(parameters, "strength"));
  program.set("mode", number_of(kModes, parameters.at("mode")));
  program.set("source", number_of(kSources, parameters.at("source")));
  program.set("silhouettes", parameters.at("silhouettes").get<bool>() ? 1 : 0);
  program.set("depth_step_mm", number(parameters, "depth_step_mm"));
  program.set("gain", is_choice(parameters, "norm", "raw") ? 1.0F : 0.25F);
  program.set("euclidean", is_choice(parameters, "gradient", "l2") ? 1 : 0);
}

constexpr std::array kShaders = {"sobel.frag"};

}  // namespace

extern const ImageFilter kSobelFilter{"sobel", kShaders, single_step, set_parameters};

}  // namespace cutaway
