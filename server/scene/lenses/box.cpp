#include <array>

#include "scene/lenses/unit_body.h"
#include "scene/lenses/unit_glsl.h"

namespace cutaway {

namespace {

using namespace unit_glsl;
#include "scene/lenses/box.glsl"

constexpr std::array<glm::dvec2, 4> kProfile{{{0.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {0.0, 1.0}}};

}  // namespace

extern const UnitBody kUnitBox{"box.glsl",  unit_interval, unit_gauge, unit_normal,
                               unit_offset, unit_rim,      kProfile,   false};

}  // namespace cutaway
