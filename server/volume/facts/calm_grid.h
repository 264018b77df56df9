// A smaller, calmer copy of a volume, in which its materials and edges are looked for.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "volume/facts/value_tally.h"

namespace cutaway {

/// Cells are means of `factor` voxels along each axis; the last ones may reach beyond the volume.
struct CalmGrid {
  VolumeGeometry geometry;    ///< of the cells' centres; patient space
  glm::ivec3 factor{1};       ///< voxels a cell
  std::vector<float> values;  ///< physical, within the robust range; i fastest

  std::size_t at(glm::ivec3 cell) const {
    const glm::ivec3 size = geometry.size_voxels;
    return (std::size_t(cell.z) * size.y + cell.y) * size.x + cell.x;
  }
  glm::ivec3 cell_of(std::size_t place) const {
    const glm::ivec3 size = geometry.size_voxels;
    return {int(place % size.x), int(place / size.x % size.y), int(place / size.x / size.y)};
  }
  double cell_mm3() const {
    return geometry.spacing_mm.x * geometry.spacing_mm.y * geometry.spacing_mm.z;
  }
};

/// Cells at least `cell_mm` apart where voxels are closer, and not more than `most_cells`. What is
/// beyond the robust range counts as its end; a sentinel as its lower end.
CalmGrid calm_grid(const Volume& volume, const RobustRange& robust, double cell_mm,
                   std::size_t most_cells, const std::stop_token& stop);

/// Gaussian of one cell's width (a half where cells are more than 2.5 times the smallest apart).
void smooth(CalmGrid& grid, const std::stop_token& stop);

}  // namespace cutaway
