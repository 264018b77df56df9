// JPEG from planes, decoded by TurboJPEG and compared with the colours that went in.
#include "encode/jpeg.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/error.h"

namespace cutaway {
namespace {

struct Colour {
  double red, green, blue;
};

/// Full-range YCbCr of ITU-T T.871.
std::array<std::uint8_t, 3> ycbcr(const Colour& c) {
  const double y = (0.299 * c.red) + (0.587 * c.green) + (0.114 * c.blue);
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  return {byte(y), byte(128.0 + ((c.blue - y) / 1.772)), byte(128.0 + ((c.red - y) / 1.402))};
}

/// Left half and right half in a colour each, as the renderer hands pictures over.
Picture two_colours(PixelLayout layout, glm::ivec2 size_px, const Colour& left,
                    const Colour& right) {
  const int block = layout == PixelLayout::yuv420 ? 2 : 1;
  std::vector<PixelPlane> planes;
  for (const PlaneShape& shape : plane_shapes(layout, size_px)) {
    const std::size_t index = planes.size();
    PixelPlane plane(shape.size_px, shape.bytes_per_pixel);
    for (int row = 0; row < shape.size_px.y; ++row) {
      for (int column = 0; column < shape.size_px.x; ++column) {
        const bool is_left = column * (index == 0 ? 1 : block) < size_px.x / 2;
        plane.row(row)[static_cast<std::size_t>(column)] = ycbcr(is_left ? left : right).at(index);
      }
    }
    planes.push_back(std::move(plane));
  }
  return {layout, size_px, std::move(planes)};
}

struct Decoded {
  int width_px = 0;
  int height_px = 0;
  int sampling = -1;
  std::vector<std::uint8_t> rgb;

  const std::uint8_t* at(int column, int row) const {
    return &rgb.at((static_cast<std::size_t>(row) * width_px + column) * 3);
  }
};

Decoded decode(const JpegPicture& file) {
  const std::vector<std::uint8_t>& jpeg = file.bytes;
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  Decoded picture;
  int colour_space = -1;
  EXPECT_EQ(tjDecompressHeader3(decoder.get(), jpeg.data(), jpeg.size(), &picture.width_px,
                                &picture.height_px, &picture.sampling, &colour_space),
            0);
  EXPECT_EQ(colour_space, TJCS_YCbCr);
  EXPECT_EQ(glm::ivec2(picture.width_px, picture.height_px), file.size_px);
  picture.rgb.resize(static_cast<std::size_t>(picture.width_px) * picture.height_px * 3);
  EXPECT_EQ(tjDecompress2(decoder.get(), jpeg.data(), jpeg.size(), picture.rgb.data(),
                          picture.width_px, 0, picture.height_px, TJPF_RGB, TJFLAG_ACCURATEDCT),
            0);
  return picture;
}

/// Rounding of YCbCr and of the coefficients at quality 95.
constexpr int kTolerance = 6;

void expect_colour(const std::uint8_t* rgb, const Colour& expected) {
  EXPECT_NEAR(rgb[0], expected.red, kTolerance);
  EXPECT_NEAR(rgb[1], expected.green, kTolerance);
  EXPECT_NEAR(rgb[2], expected.blue, kTolerance);
}

constexpr Colour kBone{240, 226, 180};
constexpr Colour kVessel{180, 40, 60};

struct Case {
  int width_px;
  int height_px;
  PixelLayout layout;
};

class Jpegs : public ::testing::TestWithParam<Case> {};

TEST_P(Jpegs, DecodeToTheColoursThatWentIn) {
  const auto [width, height, layout] = GetParam();
  const Picture picture = two_colours(layout, {width, height}, kBone, kVessel);
  const Decoded decoded = decode(encode_jpeg(picture, 95));
  EXPECT_EQ(decoded.sampling, layout == PixelLayout::yuv420 ? TJSAMP_420 : TJSAMP_444);
  ASSERT_EQ(decoded.width_px, width);
  ASSERT_EQ(decoded.height_px, height);
  if (width >= 16) expect_colour(decoded.at(1, 0), kBone);
  expect_colour(decoded.at(width - 1, 0), kVessel);
  expect_colour(decoded.at(width - 1, height - 1), kVessel);
}

INSTANTIATE_TEST_SUITE_P(
    EvenAndOddSizes, Jpegs,
    ::testing::Values(Case{64, 48, PixelLayout::yuv420}, Case{64, 48, PixelLayout::yuv444},
                      Case{63, 47, PixelLayout::yuv420}, Case{63, 47, PixelLayout::yuv444},
                      Case{33, 16, PixelLayout::yuv420}, Case{16, 33, PixelLayout::yuv444},
                      Case{1, 1, PixelLayout::yuv420}, Case{1, 1, PixelLayout::yuv444},
                      Case{1, 9, PixelLayout::yuv420}, Case{2049, 1, PixelLayout::yuv420},
                      Case{3840, 17, PixelLayout::yuv444}));

TEST(Jpeg, IsSmallerAndCoarserAtALowerQuality) {
  PixelPlane noise({64, 64}, 1);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x)
      noise.row(y)[static_cast<std::size_t>(x)] =
          static_cast<std::uint8_t>((y * 64 + x) * 97 % 251);
  }
  const Picture picture(PixelLayout::yuv444, {64, 64}, {noise, noise, noise});
  EXPECT_LT(encode_jpeg(picture, 20).bytes.size(), encode_jpeg(picture, 90).bytes.size());
}

void expect_refused(const Picture& picture, int quality) {
  try {
    encode_jpeg(picture, quality);
    ADD_FAILURE() << quality;
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::internal);
  }
}

TEST(Jpeg, RefusesAQualityThatThereIsNot) {
  const Picture picture = two_colours(PixelLayout::yuv420, {16, 16}, kBone, kVessel);
  for (const int quality : {-1, 101}) expect_refused(picture, quality);
  EXPECT_NO_THROW(encode_jpeg(picture, 1));
  EXPECT_NO_THROW(encode_jpeg(picture, 100));
}

TEST(Jpeg, RefusesAnEmptyPictureAndOneOfRgba) {
  expect_refused(Picture(PixelLayout::yuv420, {0, 0}), 80);
  expect_refused(Picture(PixelLayout::rgba, {16, 16}), 80);
  expect_refused(Picture(), 80);
}

}  // namespace
}  // namespace cutaway
