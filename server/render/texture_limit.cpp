#include "render/texture_limit.h"

#include <algorithm>

#include "core/error.h"

namespace cutaway {

void check_texture_limit(glm::ivec3 size_voxels, int largest_edge_voxels) {
  const int longest = std::max({size_voxels.x, size_voxels.y, size_voxels.z});
  if (longest <= largest_edge_voxels) return;
  throw Error({.code = ErrorCode::volume_refused,
               .message = "the volume is too large for the renderer",
               .field = "/volume",
               .expected = "at most " + std::to_string(largest_edge_voxels) + " voxels an edge",
               .received = std::to_string(longest)});
}

}  // namespace cutaway
