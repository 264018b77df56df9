#pragma once

#include <span>

#include "render/filters/image_filter.h"

namespace cutaway {

/// Every filter; its parameters' names, ranges and defaults are in the scene's schema.
std::span<const ImageFilter> image_filters();

}  // namespace cutaway
