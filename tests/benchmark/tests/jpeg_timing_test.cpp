#include "benchmark/jpeg_timing.h"

#include <gtest/gtest.h>

namespace cutaway::benchmark {
namespace {

/// Grey, 4:2:0.
Picture grey() {
  std::vector<PixelPlane> planes;
  for (const PlaneShape& shape : plane_shapes(PixelLayout::yuv420, {25, 16}))
    planes.emplace_back(shape.size_px, 1,
                        std::vector<std::uint8_t>(packed_bytes(shape.size_px, 1), 128));
  return {PixelLayout::yuv420, {25, 16}, std::move(planes)};
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

}  // namespace
}  // namespace cutaway::benchmark
