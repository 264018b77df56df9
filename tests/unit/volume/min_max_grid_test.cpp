#include "volume/min_max_grid.h"

#include <gtest/gtest.h>

#include <random>

#include "support/analytic_volumes.h"

namespace cutaway {
namespace {

Volume random_volume(glm::ivec3 size, bool as_float, double scale) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> value(0, 65535);
  Volume volume;
  volume.geometry = test::centred_geometry(size, test::kAnisotropicSpacingMm);
  volume.value_scale = scale;
  volume.value_offset = 3.7;
  std::vector<std::uint16_t> stored(std::size_t(size.x) * size.y * size.z);
  for (std::uint16_t& v : stored) v = std::uint16_t(value(random));
  if (as_float) {
    volume.voxels = std::vector<float>(stored.begin(), stored.end());
  } else {
    volume.voxels = stored;
  }
  return volume;
}

std::size_t brick_of(const MinMaxGrid& grid, glm::dvec3 index) {
  const glm::ivec3 brick =
      glm::min(glm::ivec3(index / double(grid.brick_size)), grid.size_bricks - 1);
  return (std::size_t(brick.z) * grid.size_bricks.y + brick.y) * grid.size_bricks.x + brick.x;
}

struct GridCase {
  glm::ivec3 size;
  int brick_size;
  bool as_float;
  double scale;
};

class EveryGrid : public testing::TestWithParam<GridCase> {};

TEST_P(EveryGrid, BoundsHoldForEveryTrilinearSample) {
  const Volume volume = random_volume(GetParam().size, GetParam().as_float, GetParam().scale);
  const MinMaxGrid grid = build_min_max_grid(volume, GetParam().brick_size, {}, {});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  constexpr double kRounding = 1e-9;  // of the interpolation in double precision
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 index =
        glm::dvec3(unit(random), unit(random), unit(random)) * glm::dvec3(GetParam().size - 1);
    const double value = sample(volume, index);
    const std::size_t brick = brick_of(grid, index);
    EXPECT_GE(value, grid.minimum[brick] - kRounding);
    EXPECT_LE(value, grid.maximum[brick] + kRounding);
  }
}

TEST_P(EveryGrid, BoundsAreThoseOfTheBricksOwnVoxels) {
  const Volume volume = random_volume(GetParam().size, GetParam().as_float, GetParam().scale);
  const MinMaxGrid grid = build_min_max_grid(volume, GetParam().brick_size, {}, {});
  const glm::ivec3 brick = grid.size_bricks - 1;
  const glm::ivec3 first = brick * grid.brick_size;
  const glm::ivec3 last = glm::min(first + grid.brick_size, GetParam().size - 1);
  double lowest = 1e9;
  double highest = -1e9;
  for (int k = first.z; k <= last.z; ++k) {
    for (int j = first.y; j <= last.y; ++j) {
      for (int i = first.x; i <= last.x; ++i) {
        lowest = std::min(lowest, value_at(volume, {i, j, k}));
        highest = std::max(highest, value_at(volume, {i, j, k}));
      }
    }
  }
  EXPECT_FLOAT_EQ(grid.minimum.back(), float(lowest));
  EXPECT_FLOAT_EQ(grid.maximum.back(), float(highest));
}

INSTANTIATE_TEST_SUITE_P(MinMaxGrid, EveryGrid,
                         testing::Values(GridCase{{33, 40, 25}, 8, false, 1.0},
                                         GridCase{{32, 18, 9}, 8, true, 0.1},
                                         GridCase{{31, 50, 12}, 4, false, 0.31},
                                         GridCase{{5, 1, 20}, 8, false, 1.0},
                                         GridCase{{19, 20, 21}, 3, true, 2.0}));

TEST(MinMaxGrid, CountsBricksOfCellsNotVoxels) {
  const auto bricks = [](glm::ivec3 size) {
    return build_min_max_grid(random_volume(size, false, 1.0), 8, {}, {}).size_bricks;
  };
  EXPECT_EQ(bricks({9, 10, 17}), glm::ivec3(1, 2, 2));
  EXPECT_EQ(bricks({1, 2, 8}), glm::ivec3(1, 1, 1));
}

TEST(MinMaxGrid, ReportsItsStageAndCanBeCancelled) {
  const Volume volume = random_volume({40, 40, 40}, false, 1.0);
  double last = 0.0;
  build_min_max_grid(volume, 8,
                     [&](LoadStage stage, double fraction) {
                       EXPECT_EQ(stage, LoadStage::min_max);
                       EXPECT_GE(fraction, last);
                       last = fraction;
                     },
                     {});
  EXPECT_EQ(last, 1.0);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(build_min_max_grid(volume, 8, {}, source.get_token()), Cancelled);
}

}  // namespace
}  // namespace cutaway
