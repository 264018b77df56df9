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
class TwoColours {
 public:
  TwoColours(int width_px, int height_px, bool halved_chroma, const Colour& left,
             const Colour& right)
      : width_px_(width_px), height_px_(height_px), halved_(halved_chroma) {
    const int block = halved_ ? 2 : 1;
    const int columns = (width_px + block - 1) / block;
    const int rows = (height_px + block - 1) / block;
    fill(0, columns * block, rows * block, 1, left, right);
    fill(1, columns, rows, block, left, right);
    fill(2, columns, rows, block, left, right);
  }

  YcbcrPlanes planes() const {
    return {.width_px = width_px_,
            .height_px = height_px_,
            .halved_chroma = halved_,
            .planes = {planes_[0], planes_[1], planes_[2]}};
  }

 private:
  void fill(std::size_t plane, int columns, int rows, int block, const Colour& left,
            const Colour& right) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const bool is_left = column * block < width_px_ / 2;
        planes_.at(plane).push_back(ycbcr(is_left ? left : right).at(plane));
      }
    }
  }

  int width_px_;
  int height_px_;
  bool halved_;
  std::array<std::vector<std::uint8_t>, 3> planes_;
};

struct Decoded {
  int width_px = 0;
  int height_px = 0;
  int sampling = -1;
  std::vector<std::uint8_t> rgb;

  const std::uint8_t* at(int column, int row) const {
    return &rgb.at((static_cast<std::size_t>(row) * width_px + column) * 3);
  }
};

Decoded decode(const std::vector<std::uint8_t>& jpeg) {
  const std::unique_ptr<void, int (*)(void*)> decoder(tjInitDecompress(), tjDestroy);
  Decoded picture;
  int colour_space = -1;
  EXPECT_EQ(tjDecompressHeader3(decoder.get(), jpeg.data(), jpeg.size(), &picture.width_px,
                                &picture.height_px, &picture.sampling, &colour_space),
            0);
  EXPECT_EQ(colour_space, TJCS_YCbCr);
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
  bool halved_chroma;
};

class Jpegs : public ::testing::TestWithParam<Case> {};

TEST_P(Jpegs, DecodeToTheColoursThatWentIn) {
  const auto [width, height, halved] = GetParam();
  const TwoColours picture(width, height, halved, kBone, kVessel);
  const Decoded decoded = decode(encode_jpeg(picture.planes(), 95));
  EXPECT_EQ(decoded.sampling, halved ? TJSAMP_420 : TJSAMP_444);
  ASSERT_EQ(decoded.width_px, width);
  ASSERT_EQ(decoded.height_px, height);
  if (width >= 16) expect_colour(decoded.at(1, 0), kBone);
  expect_colour(decoded.at(width - 1, 0), kVessel);
  expect_colour(decoded.at(width - 1, height - 1), kVessel);
}

INSTANTIATE_TEST_SUITE_P(EvenAndOddSizes, Jpegs,
                         ::testing::Values(Case{64, 48, true}, Case{64, 48, false},
                                           Case{63, 47, true}, Case{63, 47, false},
                                           Case{33, 16, true}, Case{16, 33, false},
                                           Case{1, 1, true}, Case{1, 1, false}, Case{1, 9, true}));

TEST(Jpeg, IsSmallerAndCoarserAtALowerQuality) {
  std::vector<std::uint8_t> noise(std::size_t{64} * 64);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<std::uint8_t>(i * 97 % 251);
  const YcbcrPlanes picture{
      .width_px = 64, .height_px = 64, .halved_chroma = false, .planes = {noise, noise, noise}};
  EXPECT_LT(encode_jpeg(picture, 20).size(), encode_jpeg(picture, 90).size());
}

TEST(Jpeg, RefusesAQualityThatThereIsNot) {
  const TwoColours picture(16, 16, true, kBone, kVessel);
  for (const int quality : {-1, 101}) {
    try {
      encode_jpeg(picture.planes(), quality);
      ADD_FAILURE() << quality;
    } catch (const Error& error) {
      EXPECT_EQ(error.detail().code, "internal");
    }
  }
  EXPECT_NO_THROW(encode_jpeg(picture.planes(), 1));
  EXPECT_NO_THROW(encode_jpeg(picture.planes(), 100));
}

TEST(Jpeg, RefusesAnEmptyPicture) {
  EXPECT_THROW(
      encode_jpeg({.width_px = 0, .height_px = 0, .halved_chroma = true, .planes = {}}, 80), Error);
}

TEST(JpegDeathTest, PlanesOfAnotherSizeAreOurOwnFault) {
  const TwoColours picture(15, 15, false, kBone, kVessel);
  YcbcrPlanes wrong = picture.planes();
  wrong.halved_chroma = true;
  EXPECT_DEATH(encode_jpeg(wrong, 80), "size of the luma plane");
}

}  // namespace
}  // namespace cutaway
