#include <algorithm>

#include "volume/min_max_grid.h"

namespace cutaway {

namespace {

/// Bricks, both ends included; empty where first > last.
struct BrickBox {
  glm::ivec3 first;
  glm::ivec3 last;
};

BrickBox bricks_reaching(const MinMaxGrid& grid, double value) {
  BrickBox box{grid.size_bricks, glm::ivec3(-1)};
  std::size_t at = 0;
  for (int k = 0; k < grid.size_bricks.z; ++k) {
    for (int j = 0; j < grid.size_bricks.y; ++j) {
      for (int i = 0; i < grid.size_bricks.x; ++i, ++at) {
        if (grid.maximum[at] < value) continue;
        box.first = glm::min(box.first, glm::ivec3(i, j, k));
        box.last = glm::max(box.last, glm::ivec3(i, j, k));
      }
    }
  }
  return box;
}

}  // namespace

BoundingBox bounds_reaching_mm(const MinMaxGrid& grid, const VolumeGeometry& geometry,
                               double value) {
  const BrickBox box = bricks_reaching(grid, value);
  if (box.first.x > box.last.x) return bounds_patient_mm(geometry);
  const glm::ivec3 first = box.first * grid.brick_size;
  const glm::ivec3 last = glm::min((box.last + 1) * grid.brick_size, geometry.size_voxels - 1);
  return bounds_patient_mm(part_of(geometry, first, last));
}

}  // namespace cutaway
