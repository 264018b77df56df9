#pragma once

#include <span>

#include "render/shading/shading_model.h"

namespace cutaway {

/// Every shading model; its parameters' names, ranges and defaults are in the scene's schema.
std::span<const ShadingModel> shading_models();

}  // namespace cutaway
