// "WIDTHxHEIGHT" on the command line.
#pragma once

#include <string>

#include "scene/scene.h"

namespace cutaway {

/// In pixels. Throws Error where it is none, or no picture can be of this size.
Viewport parse_picture_size(const std::string& text);

/// Throws Error where no picture can be of this size.
void check_picture_size(Viewport size);

}  // namespace cutaway
