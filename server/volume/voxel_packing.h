// From whatever number type a reader delivers to one of the two that a Volume stores.
#pragma once

#include <cstdint>
#include <span>

#include "volume/volume.h"

namespace cutaway {

struct PackedVoxels {
  Voxels voxels;
  double value_scale = 1.0;  ///< above 0, as Volume wants it
  double value_offset = 0.0;
  ValueRange value_range;
  std::size_t replaced_non_finite = 0;  ///< NaN and infinities, set to the smallest finite value
};

/// Integers whose range fits 16 bits are stored as uint16: their distance from the smallest, or,
/// where `slope` is negative, from the largest. Everything else as float, scaled where the numbers
/// are too large or small to calculate with. `slope` and `intercept` are the file's own rescale
/// where the reader has not applied it, else 1 and 0. Instantiated for the 8 to 32 bit integers,
/// float and double. Throws Error where no value is finite.
template <typename T>
PackedVoxels pack_voxels(std::span<const T> values, double slope = 1.0, double intercept = 0.0);

}  // namespace cutaway
