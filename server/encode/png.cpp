#include "encode/png.h"

#include <png.h>

#include <string>

#include "core/check.h"
#include "core/error.h"

namespace cutaway {

namespace {

std::vector<std::uint8_t> without_alpha(std::span<const std::uint8_t> rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
    rgb.insert(rgb.end(), &rgba[i], &rgba[i] + 3);
  return rgb;
}

}  // namespace

std::vector<std::uint8_t> encode_png(std::span<const std::uint8_t> rgba, int width_px,
                                     int height_px) {
  check_equal(rgba.size(), static_cast<std::size_t>(width_px) * height_px * 4,
              "size of the picture");
  const auto rgb = without_alpha(rgba);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_px);
  image.height = static_cast<png_uint_32>(height_px);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::uint8_t> png(size);
  if (png_image_write_to_memory(&image, png.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw Error({.code = "internal", .message = std::string("PNG: ") + image.message});
  }
  png.resize(size);
  return png;
}

}  // namespace cutaway
