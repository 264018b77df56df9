#include "volume/min_max_grid.h"

namespace cutaway {

VoxelBox box_of_bricks(const MinMaxGrid& grid, glm::ivec3 size_voxels,
                       const std::function<bool(std::size_t)>& is_wanted) {
  glm::ivec3 first = grid.size_bricks;
  glm::ivec3 last(-1);
  std::size_t at = 0;
  glm::ivec3 brick;
  for (brick.z = 0; brick.z < grid.size_bricks.z; ++brick.z) {
    for (brick.y = 0; brick.y < grid.size_bricks.y; ++brick.y) {
      for (brick.x = 0; brick.x < grid.size_bricks.x; ++brick.x, ++at) {
        if (!is_wanted(at)) continue;
        first = glm::min(first, brick);
        last = glm::max(last, brick);
      }
    }
  }
  if (last.x < first.x) return {glm::ivec3(0), size_voxels - 1};
  return {first * grid.brick_size, glm::min((last + 1) * grid.brick_size, size_voxels - 1)};
}

BoundingBox bounds_reaching_mm(const MinMaxGrid& grid, const VolumeGeometry& geometry,
                               double value) {
  const VoxelBox box = box_of_bricks(grid, geometry.size_voxels,
                                     [&](std::size_t at) { return grid.maximum[at] >= value; });
  return bounds_patient_mm(part_of(geometry, box.first, box.last));
}

}  // namespace cutaway
