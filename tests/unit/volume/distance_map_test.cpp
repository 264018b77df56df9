#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "volume/min_max_grid.h"

namespace cutaway {
namespace {

/// Bricks hold exactly one value each: 1 where occupied, 0 elsewhere.
MinMaxGrid random_grid(glm::ivec3 size, double occupied_share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution occupied(occupied_share);
  MinMaxGrid grid;
  grid.size_bricks = size;
  for (int i = 0; i < size.x * size.y * size.z; ++i) {
    grid.minimum.push_back(occupied(random) ? 1.0f : 0.0f);
  }
  grid.maximum = grid.minimum;
  return grid;
}

template <typename Function>
void for_each_brick(glm::ivec3 size, const Function& function) {
  for (int k = 0, at = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) function(glm::ivec3(i, j, k), at++);
    }
  }
}

int brute_force(const MinMaxGrid& grid, glm::ivec3 from) {
  int nearest = 255;
  for_each_brick(grid.size_bricks, [&](glm::ivec3 brick, int at) {
    const glm::ivec3 apart = glm::abs(brick - from);
    if (grid.maximum[at] >= 1.0f)
      nearest = std::min({nearest, std::max({apart.x, apart.y, apart.z})});
  });
  return nearest;
}

TEST(ChebyshevDistanceMap, EqualsBruteForce) {
  const std::vector<glm::ivec3> sizes{{17, 9, 12}, {1, 20, 3}, {40, 2, 1}, {8, 8, 8}, {1, 1, 30}};
  for (const glm::ivec3 size : sizes) {
    for (const double share : {0.0, 0.003, 0.02, 0.3, 1.0}) {
      const MinMaxGrid grid = random_grid(size, share, unsigned(size.x));
      const std::vector<std::uint8_t> distances = chebyshev_distance_map(grid, {0.5});
      for_each_brick(size, [&](glm::ivec3 brick, int at) {
        ASSERT_EQ(int(distances[at]), brute_force(grid, brick)) << "share " << share;
      });
    }
  }
}

TEST(ChebyshevDistanceMap, SaturatesWithoutAnyBrickAndBeyond255) {
  MinMaxGrid grid = random_grid({300, 1, 2}, 0.0, 1);
  EXPECT_EQ(chebyshev_distance_map(grid, {0.5}), std::vector<std::uint8_t>(600, 255));
  grid.minimum[0] = grid.maximum[0] = 1.0f;
  const std::vector<std::uint8_t> distances = chebyshev_distance_map(grid, {0.5});
  EXPECT_EQ(int(distances[254]), 254);
  EXPECT_EQ(int(distances[299]), 255);
  EXPECT_EQ(int(distances[300]), 1);
}

TEST(ChebyshevDistanceMap, CountsBricksThatHoldSomeOfTheBand) {
  MinMaxGrid grid = random_grid({3, 1, 1}, 0.0, 1);
  grid.minimum = {0.0f, 10.0f, 20.0f};
  grid.maximum = {10.0f, 20.0f, 30.0f};
  EXPECT_EQ(chebyshev_distance_map(grid, {9.9}), (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(chebyshev_distance_map(grid, {10.0}), (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(chebyshev_distance_map(grid, {20.0}), (std::vector<std::uint8_t>{2, 1, 0}));
  EXPECT_EQ(chebyshev_distance_map(grid, {-5.0, 10.0}), (std::vector<std::uint8_t>{0, 1, 2}));
  EXPECT_EQ(chebyshev_distance_map(grid, {12.0, 18.0}), (std::vector<std::uint8_t>{1, 0, 1}));
}

}  // namespace
}  // namespace cutaway
