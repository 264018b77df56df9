// How large a volume the renderer can hold in one texture.
#pragma once

#include <glm/glm.hpp>

namespace cutaway {

/// Throws Error "volume-refused" where an edge is longer than the device's 3-D textures can be.
void check_texture_limit(glm::ivec3 size_voxels, int largest_edge_voxels);

}  // namespace cutaway
