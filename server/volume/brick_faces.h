// The outside of the bricks that hold something, as triangles: rasterised, they tell each ray where
// the first of them begins.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace cutaway {

/// Cubes of `block_bricks` bricks an edge, of which a block is filled where any of its bricks is.
struct BlockGrid {
  int block_bricks = 1;
  glm::ivec3 size_blocks{0};
  std::vector<bool> filled;  ///< i fastest
};

/// About 16 blocks along the longest edge, so that there are as many triangles for a large volume
/// as for a small one. `is_filled` says it of each brick, i fastest.
BlockGrid block_grid(glm::ivec3 size_bricks, const std::vector<bool>& is_filled);

/// A corner of a triangle, counted in blocks from the grid's origin; the last component is 0.
using BlockCorner = glm::u8vec4;

/// Three corners a triangle, two triangles for each face between a filled block and one that is
/// not, or the outside.
std::vector<BlockCorner> block_faces(const BlockGrid& grid);

}  // namespace cutaway
