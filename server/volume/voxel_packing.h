// From whatever number type a reader delivers to one of the two that a Volume stores.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "volume/volume.h"

namespace cutaway {

struct PackedVoxels {
  Voxels voxels;
  double value_scale = 1.0;  ///< above 0, as Volume wants it
  double value_offset = 0.0;
  ValueRange value_range;
  std::optional<double> nothing_value;  ///< of voxels without a value, as Volume has it
  std::size_t nothing_voxels = 0;       ///< how many those are
};

/// What a file's numbers may be; what lies outside says that there is no value.
template <typename T>
struct ValidValues {
  T lowest = std::numeric_limits<T>::lowest();
  T highest = std::numeric_limits<T>::max();
  bool holds(T value) const { return value >= lowest && value <= highest; }  ///< no NaN
};

/// Integers whose range fits 16 bits are stored as uint16: their distance from the smallest, or,
/// where `slope` is negative, from the largest. Everything else as float, scaled where the numbers
/// are too large or small to calculate with. Voxels without a value (not finite, or not `valid`)
/// get one below all others: by 1 where all values are whole, so that labels from 1 on get 0.
/// `slope` and `intercept` are the file's own rescale where the reader has not applied it, else 1
/// and 0. `consumed` hears how many values from the front will not be read again. Instantiated for
/// the 8 to 32 bit integers, float and double. Throws Error where no voxel has a value.
template <typename T>
PackedVoxels pack_voxels(std::span<const T> values, double slope = 1.0, double intercept = 0.0,
                         const ValidValues<T>& valid = {},
                         const std::function<void(std::size_t values)>& consumed = {});

}  // namespace cutaway
