#include <array>

#include "scene/lenses/unit_body.h"
#include "scene/lenses/unit_glsl.h"

namespace cutaway {

namespace {

using namespace unit_glsl;
#include "scene/lenses/cone.glsl"

constexpr std::array<glm::dvec2, 3> kProfile{{{0.0, -1.0}, {1.0, 1.0}, {0.0, 1.0}}};

}  // namespace

extern const UnitBody kUnitCone{"cone.glsl", unit_interval, unit_gauge, unit_normal,
                                unit_offset, unit_rim,      kProfile};

}  // namespace cutaway
