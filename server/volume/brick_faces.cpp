#include "volume/brick_faces.h"

#include <algorithm>
#include <array>

#include "core/check.h"

namespace cutaway {

namespace {

constexpr int kBlocksAlongEdge = 16;

std::size_t place(glm::ivec3 at, glm::ivec3 size) {
  return (static_cast<std::size_t>(at.z) * size.y + at.y) * size.x + at.x;
}

bool is_filled(const BlockGrid& grid, glm::ivec3 block) {
  const bool inside = glm::all(glm::greaterThanEqual(block, glm::ivec3(0))) &&
                      glm::all(glm::lessThan(block, grid.size_blocks));
  return inside && grid.filled[place(block, grid.size_blocks)];
}

/// The face of a block across an axis; `side` 0: its low end, 1: its high one.
void add_face(glm::ivec3 block, int axis, int side, std::vector<BlockCorner>& corners) {
  constexpr std::array<glm::ivec2, 6> kSquare = {{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};
  for (const glm::ivec2 offset : kSquare) {
    glm::ivec3 corner = block;
    corner[axis] += side;
    corner[(axis + 1) % 3] += offset.x;
    corner[(axis + 2) % 3] += offset.y;
    corners.emplace_back(corner.x, corner.y, corner.z, 0);
  }
}

template <typename Visit>
void for_each_cell(glm::ivec3 size, const Visit& visit) {
  glm::ivec3 at;
  for (at.z = 0; at.z < size.z; ++at.z) {
    for (at.y = 0; at.y < size.y; ++at.y) {
      for (at.x = 0; at.x < size.x; ++at.x) visit(at);
    }
  }
}

}  // namespace

BlockGrid block_grid(glm::ivec3 size_bricks, const std::vector<bool>& is_filled) {
  check_equal(is_filled.size(), place({0, 0, size_bricks.z}, size_bricks), "one answer a brick");
  const int longest = std::max({size_bricks.x, size_bricks.y, size_bricks.z});
  BlockGrid grid;
  grid.block_bricks = std::max(1, (longest + kBlocksAlongEdge - 1) / kBlocksAlongEdge);
  grid.size_blocks = (size_bricks + grid.block_bricks - 1) / grid.block_bricks;
  grid.filled.resize(place({0, 0, grid.size_blocks.z}, grid.size_blocks));
  for_each_cell(size_bricks, [&](glm::ivec3 brick) {
    if (is_filled[place(brick, size_bricks)])
      grid.filled[place(brick / grid.block_bricks, grid.size_blocks)] = true;
  });
  return grid;
}

std::vector<BlockCorner> block_faces(const BlockGrid& grid) {
  std::vector<BlockCorner> corners;
  for_each_cell(grid.size_blocks, [&](glm::ivec3 block) {
    if (!is_filled(grid, block)) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        glm::ivec3 neighbour = block;
        neighbour[axis] += 2 * side - 1;
        if (!is_filled(grid, neighbour)) add_face(block, axis, side, corners);
      }
    }
  });
  return corners;
}

}  // namespace cutaway
