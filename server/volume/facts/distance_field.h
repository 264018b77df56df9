// Exact distances on a grid.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <stop_token>
#include <vector>

namespace cutaway {

/// A grid of cells, `spacing_mm` apart; i fastest.
struct CellGrid {
  glm::ivec3 size{0};
  glm::dvec3 spacing_mm{1.0};

  std::size_t count() const { return std::size_t(size.x) * size.y * size.z; }
  std::size_t at(glm::ivec3 cell) const {
    return (std::size_t(cell.z) * size.y + cell.y) * size.x + cell.x;
  }
};

using CellMask = std::vector<std::uint8_t>;  ///< 0: no, else yes

/// For each cell the distance (mm, between centres) to the nearest cell of the mask; infinite where
/// the mask is empty. What lies beyond the grid is not looked at. Source: P. Felzenszwalb, D.
/// Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8, 2012.
std::vector<float> distance_to_mm(const CellGrid& grid, const CellMask& mask,
                                  const std::stop_token& stop);

/// Limits depths by the distance to the grid's faces, but for those at the ends of axis `along`: a
/// plate that a face cuts is as thin as what is seen of it.
void limit_by_sides(const CellGrid& grid, int along, std::vector<float>& depth_mm);

/// 1 where the mask is 0.
CellMask inverted(const CellMask& mask);

}  // namespace cutaway
