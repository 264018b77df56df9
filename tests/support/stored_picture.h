// A picture that lies in a file.
#pragma once

#include <filesystem>

#include "support/picture_difference.h"

namespace cutaway::test {

/// Of a PNG; what has no alpha is opaque. Throws std::runtime_error naming the file.
BytePicture read_png(const std::filesystem::path& file);

}  // namespace cutaway::test
