// The registries of modules as protocol/schema/modules.schema.json has them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/json.h"

namespace cutaway {

/// {"shading": [...], "filter": [...], "lens_shape": [...]}: for each module its name, title,
/// description and parameters with type, range, step, unit, choices, default and level, in the
/// schema's order; a lens shape has its outline, too. The `modules` part of `capabilities`.
/// Thread-safe.
const Json& describe_modules();

/// A parameter that is a half size of the lens' body.
struct LensAxis {
  int axis = 0;  ///< 0 to 2: the body's x, y, z
  std::string parameter;
};

/// What the schema says of a lens shape's half sizes; the others are 1. Thread-safe.
const std::vector<LensAxis>& lens_axes(std::string_view shape);

}  // namespace cutaway
