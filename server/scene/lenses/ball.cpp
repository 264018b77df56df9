#include <array>
#include <glm/gtc/constants.hpp>

#include "scene/lenses/unit_body.h"
#include "scene/lenses/unit_glsl.h"

namespace cutaway {

namespace {

using namespace unit_glsl;
#include "scene/lenses/ball.glsl"

// NOLINTNEXTLINE(cert-err58-cpp): nothing here throws
const auto kHalfCircle = [] {
  std::array<glm::dvec2, 33> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double angle = glm::pi<double>() * double(i) / double(corners.size() - 1);
    corners[i] = {std::sin(angle), -std::cos(angle)};
  }
  return corners;
}();

}  // namespace

extern const UnitBody kUnitBall{"ball.glsl", unit_interval, unit_gauge, unit_normal,
                                unit_offset, unit_rim,      kHalfCircle};

}  // namespace cutaway
