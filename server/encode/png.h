// Lossless stills.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cutaway {

/// Display-encoded sRGB, 4 bytes a pixel, rows top first; alpha is dropped. Any thread. Throws
/// Error "internal".
std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, int width_px,
                                     int height_px);

}  // namespace cutaway
