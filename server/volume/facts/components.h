// Connected parts of a set of voxels, held as runs along x: memory follows the surface, not the
// volume.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <stop_token>
#include <vector>

namespace cutaway {

/// Voxels [begin, end) of the row (y, z).
struct VoxelRun {
  int begin = 0;
  int end = 0;
  int y = 0;
  int z = 0;
  int component = 0;
};

struct Component {
  std::uint64_t voxels = 0;
  glm::ivec3 first{0};  ///< of the box around it, both ends included
  glm::ivec3 last{0};
};

struct Components {
  std::vector<VoxelRun> runs;  ///< by z, y, begin
  std::vector<Component> all;

  /// Place of the one with most voxels; -1 where there is none.
  int largest() const;
};

enum class Connectivity { faces, corners };  ///< 6 or 26 neighbours

/// Appends the runs of a row as (begin, end); called from any thread.
using RowRuns = std::function<void(int y, int z, std::vector<glm::ivec2>& runs)>;

Components connected_components(glm::ivec3 size, Connectivity connectivity, const RowRuns& row,
                                const std::stop_token& stop);

/// Of the cells of a mask, i fastest.
Components connected_components(glm::ivec3 size, Connectivity connectivity,
                                const std::vector<std::uint8_t>& mask, const std::stop_token& stop);

}  // namespace cutaway
