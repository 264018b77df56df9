#include "volume/brick_faces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace cutaway {
namespace {

BlockGrid grid_of(glm::ivec3 size, const std::vector<glm::ivec3>& filled) {
  BlockGrid grid{1, size, std::vector<bool>(static_cast<std::size_t>(size.x * size.y * size.z))};
  for (const glm::ivec3 block : filled)
    grid.filled[static_cast<std::size_t>((block.z * size.y + block.y) * size.x + block.x)] = true;
  return grid;
}

TEST(BlockFaces, OfOneBlockAreItsSixSides) {
  const auto corners = block_faces(grid_of({3, 3, 3}, {{1, 1, 1}}));
  ASSERT_EQ(corners.size(), 36U);
  std::map<std::array<int, 3>, int> seen;
  for (const BlockCorner corner : corners) ++seen[{corner.x, corner.y, corner.z}];
  EXPECT_EQ(seen.size(), 8U);
  for (const auto& [corner, count] : seen) {
    for (const int at : corner) EXPECT_TRUE(at == 1 || at == 2);
    EXPECT_GE(count, 3);
  }
}

TEST(BlockFaces, HaveNoneBetweenTwoFilledBlocks) {
  EXPECT_EQ(block_faces(grid_of({2, 1, 1}, {{0, 0, 0}, {1, 0, 0}})).size(), 10U * 6U);
  EXPECT_EQ(block_faces(grid_of({2, 1, 1}, {})).size(), 0U);
}

// Along each line of blocks, faces across it mark exactly where filled begins and ends.
TEST(BlockFaces, CloseTheFilledPartOfEveryLine) {
  std::mt19937 random(2);
  std::bernoulli_distribution filled(0.4);
  BlockGrid grid = grid_of({5, 6, 7}, {});
  for (std::size_t i = 0; i < grid.filled.size(); ++i) grid.filled[i] = filled(random);
  std::size_t changes = 0;
  for (int k = 0; k < 7; ++k) {
    for (int j = 0; j < 6; ++j) {
      bool before = false;
      for (int i = 0; i <= 5; ++i) {
        const bool here = i < 5 && grid.filled[static_cast<std::size_t>((k * 6 + j) * 5 + i)];
        changes += here != before ? 1 : 0;
        before = here;
      }
    }
  }
  const auto corners = block_faces(grid);
  std::size_t across_x = 0;
  for (std::size_t i = 0; i < corners.size(); i += 6) {
    bool flat = true;
    for (std::size_t c = 1; c < 6; ++c) flat = flat && corners[i + c].x == corners[i].x;
    across_x += flat ? 1 : 0;
  }
  EXPECT_EQ(across_x, changes);
}

TEST(BlockGrids, HaveAboutSixteenBlocksWhateverTheVolumesSize) {
  for (const glm::ivec3 size : {glm::ivec3(8, 4, 2), {32, 32, 32}, {64, 64, 20}, {65, 3, 3}}) {
    const auto bricks = static_cast<std::size_t>(size.x * size.y * size.z);
    std::vector<bool> filled(bricks);
    filled[bricks - 1] = true;
    const BlockGrid grid = block_grid(size, filled);
    EXPECT_LE(grid.size_blocks.x, 16);
    EXPECT_GE(grid.size_blocks.x * grid.block_bricks, size.x);
    EXPECT_TRUE(grid.filled.back());
    EXPECT_EQ(std::count(grid.filled.begin(), grid.filled.end(), true), 1);
  }
}

}  // namespace
}  // namespace cutaway
