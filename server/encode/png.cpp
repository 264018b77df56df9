#include "encode/png.h"

#include <png.h>

#include <string>

#include "core/error.h"

namespace cutaway {

namespace {

/// Three bytes a pixel, tightly packed.
std::vector<std::uint8_t> without_alpha(const PixelPlane& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(packed_bytes(rgba.size_px(), 3));
  for (int y = 0; y < rgba.size_px().y; ++y) {
    const auto row = rgba.row(y);
    for (std::size_t i = 0; i + 3 < row.size(); i += 4) rgb.insert(rgb.end(), &row[i], &row[i] + 3);
  }
  return rgb;
}

}  // namespace

PngPicture encode_png(const Picture& picture) {
  if (picture.layout() != PixelLayout::rgba)
    throw Error(
        {.code = ErrorCode::internal, .message = "PNG: it is made from RGBA and not from YCbCr"});
  const std::vector<std::uint8_t> rgb =
      picture.planes().empty() ? std::vector<std::uint8_t>() : without_alpha(picture.plane(0));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size_px().x);
  image.height = static_cast<png_uint_32>(picture.size_px().y);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  PngPicture png{picture.size_px(), std::vector<std::uint8_t>(size)};
  if (png_image_write_to_memory(&image, png.bytes.data(), &size, 0, rgb.data(), 0, nullptr) == 0) {
    throw Error({.code = ErrorCode::internal, .message = std::string("PNG: ") + image.message});
  }
  png.bytes.resize(size);
  return png;
}

}  // namespace cutaway
