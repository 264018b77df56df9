#include "support/stored_picture.h"

#include <png.h>

#include <stdexcept>

namespace cutaway::test {

BytePicture read_png(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0)
    throw std::runtime_error(file.string() + ": " + image.message);
  image.format = PNG_FORMAT_RGBA;
  BytePicture picture{{static_cast<int>(image.width), static_cast<int>(image.height)},
                      std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0)
    throw std::runtime_error(file.string() + ": " + image.message);
  return picture;
}

}  // namespace cutaway::test
