// Numbers that stand for "no value": -32768, -9999, the largest float and their like.
#pragma once

#include <optional>
#include <span>

#include "volume/voxel_packing.h"

namespace cutaway::reading {

template <typename T>
struct NoData {
  ValidValues<T> valid;
  std::size_t voxels = 0;          ///< finite ones, outside of `valid`
  std::optional<double> number{};  ///< that they hold; one of them, where there are several
};

/// A number counts as no value where it is a custom to write it for one and it lies apart from all
/// others by more than their range: a tissue has neighbours. Works on values as stored, before the
/// rescale. Instantiated for the number types of RawVoxels.
template <typename T>
NoData<T> find_no_data(std::span<const T> values);

/// What may be mixed with its neighbours: all but numbers that count as no value, and one that lies
/// below air where all others are Hounsfield units, as scanners write it around their field of view
/// (-2000, -3024) without declaring it. `slope` and `intercept` are the file's.
template <typename T>
ValidValues<T> mixable_values(std::span<const T> values, double slope, double intercept);

}  // namespace cutaway::reading
