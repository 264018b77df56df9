// PNG: what libpng reads back is what went in.
#include "encode/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include "core/error.h"

namespace cutaway {
namespace {

std::vector<std::uint8_t> pattern(int width_px, int height_px) {
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width_px) * height_px * 4);
  for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<std::uint8_t>(i * 31 % 256);
  return rgba;
}

Picture picture_of(const std::vector<std::uint8_t>& rgba, int width_px, int height_px) {
  const glm::ivec2 size_px(width_px, height_px);
  return {PixelLayout::rgba, size_px, {PixelPlane(size_px, 4, rgba)}};
}

/// RGBA; opaque where the file has no alpha.
std::vector<std::uint8_t> decode(const std::vector<std::uint8_t>& png, int width_px,
                                 int height_px) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0) << image.message;
  EXPECT_EQ(image.width, static_cast<png_uint_32>(width_px));
  EXPECT_EQ(image.height, static_cast<png_uint_32>(height_px));
  EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, 0U);
  image.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(image));
  EXPECT_NE(png_image_finish_read(&image, nullptr, rgba.data(), 0, nullptr), 0) << image.message;
  return rgba;
}

TEST(Png, KeepsEveryColourAndDropsAlpha) {
  for (const auto& [width, height] : {std::pair{64, 48}, {63, 47}, {1, 1}, {3, 100}}) {
    std::vector<std::uint8_t> expected = pattern(width, height);
    const PngPicture png = encode_png(picture_of(expected, width, height));
    EXPECT_EQ(png.size_px, glm::ivec2(width, height));
    for (std::size_t i = 3; i < expected.size(); i += 4) expected[i] = 255;
    EXPECT_EQ(decode(png.bytes, width, height), expected) << width << "x" << height;
  }
}

TEST(Png, TheSamePictureGivesTheSameBytes) {
  const auto rgba = pattern(40, 30);
  EXPECT_EQ(encode_png(picture_of(rgba, 40, 30)).bytes, encode_png(picture_of(rgba, 40, 30)).bytes);
}

TEST(Png, RefusesAnEmptyPictureAndOneOfPlanes) {
  for (const Picture& wrong :
       {Picture(), Picture(PixelLayout::rgba, {0, 0}), Picture(PixelLayout::yuv444, {4, 4})}) {
    try {
      encode_png(wrong);
      ADD_FAILURE() << "it was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.detail().code, ErrorCode::internal);
    }
  }
}

}  // namespace
}  // namespace cutaway
