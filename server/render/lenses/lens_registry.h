#pragma once

#include <map>
#include <span>
#include <string>

#include "render/lenses/lens_shape.h"

namespace cutaway {

std::span<const LensShape> lens_shapes();

/// With these a shader's `#include LENS_SHAPE` is the shape's file.
std::map<std::string, std::string> shader_definitions(const LensShape& shape);

}  // namespace cutaway
