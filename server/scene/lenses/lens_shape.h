// The shapes that a lens can have.
#pragma once

#include <span>
#include <string_view>

#include "scene/lenses/unit_body.h"

namespace cutaway {

/// One registry entry; its parameters are in protocol/schema/modules.schema.json, where `x-axis`
/// says which half size of the body a parameter is, in radii.
struct LensShape {
  const char* name;
  const UnitBody* body;
};

/// In the order to show them.
std::span<const LensShape> lens_shapes();

/// There has to be one of that name.
const LensShape& find_lens_shape(std::string_view name);

}  // namespace cutaway
