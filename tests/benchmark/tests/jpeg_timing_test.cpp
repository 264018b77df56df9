#include "benchmark/jpeg_timing.h"

#include <gtest/gtest.h>

namespace cutaway::benchmark {
namespace {

/// Grey, 4:2:0; 25 columns come as 13 pairs.
Pixels grey() {
  return {.layout = PixelLayout::yuv420,
          .size_px = {25, 16},
          .planes = {std::vector<std::uint8_t>(std::size_t{26} * 16, 128),
                     std::vector<std::uint8_t>(std::size_t{13} * 8, 128),
                     std::vector<std::uint8_t>(std::size_t{13} * 8, 128)}};
}

TEST(JpegTiming, HasARateForEachNumberOfThreadsInTheirOrder) {
  const std::vector<int> threads = {3, 1};
  const auto rates = measure_jpeg(grey(), 80, threads, 0.05);
  ASSERT_EQ(rates.size(), 2U);
  EXPECT_EQ(rates[0].threads, 3);
  EXPECT_EQ(rates[1].threads, 1);
  for (const JpegRate& rate : rates) EXPECT_GT(rate.pictures_per_second, 0.0);
}

TEST(JpegTiming, CompressesAtLeastOnePictureInHoweverLittleTime) {
  const std::vector<int> threads = {1};
  EXPECT_GT(measure_jpeg(grey(), 80, threads, 0.0).front().pictures_per_second, 0.0);
}

TEST(JpegTiming, MakesWholeFilesOfTheChosenQuality) {
  Pixels noise = grey();
  for (std::size_t i = 0; i < noise.planes[0].size(); ++i)
    noise.planes[0][i] = static_cast<std::uint8_t>(i * 97 % 251);
  const auto jpeg = jpeg_of(noise, 90);
  ASSERT_GT(jpeg.size(), 4U);
  EXPECT_EQ(jpeg[0], 0xFF);
  EXPECT_EQ(jpeg[1], 0xD8);
  EXPECT_LT(jpeg_of(noise, 20).size(), jpeg.size());
}

TEST(JpegTiming, CountsTheBytesOfAllPlanes) { EXPECT_EQ(bytes_of(grey()), 26U * 16 + 2 * 13 * 8); }

}  // namespace
}  // namespace cutaway::benchmark
