// By what rays skip the parts of a volume in which neither branch has material.
#pragma once

#include <list>

#include "gl/program.h"
#include "gl/texture.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Of one volume and one band for each branch. Render thread only.
struct EmptySpaceMaps {
  ValueBand context;
  ValueBand focus;
  /// RG8UI: context, focus; see chebyshev_distance_map. One texture, so that a sample costs one
  /// fetch whichever branch it is of.
  gl::Texture3D distances;
  /// Triangles around the blocks that hold something of either branch; see block_faces.
  gl::VertexArrayHandle faces;
  gl::BufferHandle corners;
  int corner_count = 0;
  int block_cells = 0;  ///< edge of a block, in cells of the volume
  VoxelBox occupied;    ///< by all bricks that hold something; the volume where none does
};

/// Maps are computed at their first use (milliseconds: they go over bricks, not voxels) and kept
/// while they are among the most recently used. Render thread only.
class EmptySpace {
 public:
  /// The reference holds until the next call.
  const EmptySpaceMaps& maps(const MinMaxGrid& grid, glm::ivec3 size_voxels,
                             const ValueBand& context, const ValueBand& focus);

 private:
  std::list<EmptySpaceMaps> kept_;  ///< most recently used first
};

}  // namespace cutaway
