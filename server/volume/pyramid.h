// A volume's coarser copies: calm sources for normals at a scale and for light that is blocked.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "volume/volume.h"

namespace cutaway {

/// Means over `factor` voxels along each axis; beyond the last voxel its value is repeated. Texel i
/// has its centre at the index i * factor + (factor - 1) / 2 of the volume.
struct CoarseLevel {
  glm::ivec3 factor{1};
  glm::ivec3 size_voxels{0};
  Voxels voxels;  ///< stored as the volume's
};

/// From the finest on. An axis is halved where its spacing is less than twice the smallest, so that
/// spacings draw near each other; there is no level that an edge of fewer than eight voxels would
/// come from. Throws Cancelled.
std::vector<CoarseLevel> build_pyramid(const Volume& volume, const std::stop_token& stop);

std::size_t byte_size(const std::vector<CoarseLevel>& pyramid);

}  // namespace cutaway
