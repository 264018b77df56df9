// The smallest and largest value of each brick of voxels, by which rays skip empty space.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/value_band.h"
#include "volume/volume.h"

namespace cutaway {

/// Bricks of `brick_size` cells an edge; brick b spans the continuous indices [b*brick_size,
/// (b+1)*brick_size] on each axis, both ends included, so every trilinear sample inside a brick
/// lies between its minimum and maximum. Values are physical. (techniques: min-max brick grid.)
struct MinMaxGrid {
  int brick_size = 8;
  glm::ivec3 size_bricks{0};
  std::vector<float> minimum;  ///< i fastest
  std::vector<float> maximum;
};

MinMaxGrid build_min_max_grid(const Volume& volume, int brick_size, const ProgressSink& progress,
                              const std::stop_token& stop);

/// Voxels, both ends included.
struct VoxelBox {
  glm::ivec3 first{0};
  glm::ivec3 last{0};
};

/// The box that all bricks of which `is_wanted` holds (by their place in the grid's arrays) lie in;
/// of the whole volume where it holds of none.
VoxelBox box_of_bricks(const MinMaxGrid& grid, glm::ivec3 size_voxels,
                       const std::function<bool(std::size_t)>& is_wanted);

/// Axis-aligned patient-space bounds of the bricks that reach a value; of the whole grid where none
/// does.
BoundingBox bounds_reaching_mm(const MinMaxGrid& grid, const VolumeGeometry& geometry,
                               double value);

/// Chebyshev distance, in bricks, from each brick to the nearest one that holds some of the band: 0
/// for such a brick itself, saturated at 255. A sample in a brick of distance D may skip to the
/// exit of the cube of (2D-1) bricks centred on it: values in there are all below the band or all
/// above it. Source: L. Deakin, M. Knackstedt, "Accelerated Volume Rendering with Chebyshev
/// Distance Maps", SIGGRAPH Asia 2019 Technical Briefs.
std::vector<std::uint8_t> chebyshev_distance_map(const MinMaxGrid& grid, const ValueBand& band);

}  // namespace cutaway
