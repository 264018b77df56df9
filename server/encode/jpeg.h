// JPEG from planes that the renderer has already converted.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutaway {

/// Full-range YCbCr (ITU-T T.871), rows top first, tightly packed. With `halved_chroma` (4:2:0) the
/// chroma planes are half the picture's size, rounded up, and the luma plane is twice theirs: the
/// codec reads whole 2x2 blocks, so odd sides come padded. Else (4:4:4) all have the picture's
/// size.
struct YcbcrPlanes {
  int width_px = 0;
  int height_px = 0;
  bool halved_chroma = true;
  std::array<std::span<const std::uint8_t>, 3> planes;
};

/// quality 1..100. Any thread. Throws Error "internal" when the library refuses.
std::vector<std::uint8_t> encode_jpeg(const YcbcrPlanes& picture, int quality);

}  // namespace cutaway
