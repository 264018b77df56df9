#pragma once

#include <span>

#include "render/lenses/lens_shape.h"

namespace cutaway {

std::span<const LensShape> lens_shapes();

}  // namespace cutaway
