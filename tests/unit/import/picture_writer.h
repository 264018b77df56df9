// TIFF and PNG files for tests, by hand from the formats' definitions (TIFF 6.0, PNG 1.2), so that
// they can also lie.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace cutaway::test {

/// 16-bit grey without compression, one strip a page. Each number is what the file declares.
struct TiffPicture {
  glm::uvec2 size_px{5, 4};
  std::string pixels;  ///< in the file's byte order
  bool big_endian = false;
  glm::uvec2 resolution{1, 1};
  std::uint16_t resolution_unit = 1;  ///< 1 none, 2 inch, 3 centimetre
  std::string description = "-";
  std::uint16_t compression = 1;  ///< 1 none, 5 LZW, 8 zip
  std::uint16_t orientation = 1;
  std::uint32_t pages = 1;   ///< directories
  std::uint32_t planes = 1;  ///< that `pixels` holds; page i shows plane i, or the last
};

std::string tiff_bytes(const TiffPicture& picture);

struct PngPicture {
  glm::uvec2 size_px{5, 4};
  std::uint8_t bits = 8;
  std::uint8_t colour_type = 0;  ///< 0 grey, 2 RGB, 4 grey and alpha, 6 RGBA
  std::string pixels;            ///< of the actual rows, high byte first
  std::size_t row_bytes = 5;     ///< of those
};

std::string png_bytes(const PngPicture& picture);

}  // namespace cutaway::test
