// From slices as they were acquired to the right grid that a VolumeGeometry promises.
#pragma once

#include <string>
#include <vector>

#include "import/padding_mask.h"
#include "import/raw_voxels.h"
#include "import/refusal.h"

namespace cutaway::reading {

/// Parallel slices of one size: perhaps tilted against their stacking direction, unevenly spaced or
/// with gaps. Patient space, LPS mm.
struct SliceStack {
  glm::ivec2 size_px{0};
  glm::dvec2 pixel_spacing_mm{1.0};  ///< along i and along j
  glm::dvec3 i_axis{1, 0, 0};        ///< unit
  glm::dvec3 j_axis{0, 1, 0};        ///< unit
  std::vector<glm::dvec3>
      first_pixel_mm;              ///< centre of pixel (0,0), one a slice, in stacking order
  double position_error_mm = 0.0;  ///< of each coordinate, as the file's digits leave it open
  double axis_error = 0.0;         ///< of each cosine, likewise
};

/// Where one slice lies in the output grid, in voxels of it.
struct SlicePlacement {
  glm::dvec2 shift_px{0.0};  ///< of its pixel (0,0)
  double height = 0.0;       ///< along k
};

struct GridPlan {
  VolumeGeometry geometry;
  std::vector<SlicePlacement> placements;
  bool needs_resampling = false;
  std::vector<std::string> warnings;
};

/// Slices at even distances and straight above each other become the grid itself. Gantry tilt,
/// distances that change and gaps of up to four slices give a grid to resample to, and warnings
/// that say so. Throws Error naming `file` where no such grid is right: spacing or direction that
/// is not finite or not positive, rows and columns not at right angles, slices that coincide or run
/// back, a larger gap, a place farther from the origin than a scene's camera can be, an output
/// beyond the limit at `bytes_per_voxel`.
GridPlan plan_grid(const std::filesystem::path& file, const SliceStack& stack,
                   std::uint64_t bytes_per_voxel, const ImportLimits& limits);

/// The stack of a regular but perhaps sheared grid: index (i,j,k) is at origin + i*steps[0] +
/// j*steps[1] + k*steps[2].
SliceStack stack_of_affine(glm::ivec3 size_voxels, const glm::dmat3& steps_mm,
                           glm::dvec3 origin_mm);

/// What the numbers of a stack's pixels mean.
struct Stored {
  double slope = 1.0;  ///< the file's
  double intercept = 0.0;
  const PaddingMask* padding = nullptr;  ///< pixels that a file declares to have no value
};

/// Linear interpolation within and between slices. What has no value is not mixed with what has
/// one: a voxel takes the mean of the values around it, or, where most of its surroundings have
/// none, the number that stands there for none. Voxels that no slice covers get the smallest
/// value: air in a CT. It is the largest stored number where the slope is negative. Gives the
/// slices' memory back as it goes.
RawVoxels resample(RawVoxels slices, const SliceStack& stack, const GridPlan& plan,
                   const Stored& stored, std::stop_token stop);

}  // namespace cutaway::reading
