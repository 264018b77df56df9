// Which way up a picture is stored: TIFF's field Orientation, 274 (TIFF 6.0, section 8).
#pragma once

#include <cstddef>
#include <span>

#include "import/pictures/image_file.h"

namespace cutaway::reading {

struct Orientation {
  bool transposed = false;  ///< the first row is seen at the left or at the right
  bool from_right = false;  ///< what is stored first is seen last, from left to right
  bool from_bottom = false;

  bool is_usual() const { return !transposed && !from_right && !from_bottom; }
};

/// 1 to 8; anything else is taken for 1, the usual one.
Orientation tiff_orientation(int value);

/// From rows as stored to rows as seen, of which `seen` tells the size.
void turn(const Orientation& orientation, const PixelLayout& seen, std::span<std::byte> pixels);

}  // namespace cutaway::reading
