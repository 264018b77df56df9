// The registries of modules as protocol/schema/modules.schema.json has them.
#pragma once

#include "scene/json.h"

namespace cutaway {

/// {"shading": [...], "filter": [...], "lens_shape": [...]}: for each module its name, title,
/// description and parameters with type, range, step, unit, choices, default and level, in the
/// schema's order; the `modules` part of `capabilities`. Thread-safe.
const Json& describe_modules();

}  // namespace cutaway
