// Changing a volume's voxels by physical values.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "volume/volume.h"

namespace cutaway {

/// The stored value that is nearest to a physical one without being above it.
template <typename T>
T stored_at_most(const Volume& volume, double physical) {
  const double stored = (physical - volume.value_offset) / volume.value_scale;
  if constexpr (std::is_floating_point_v<T>) {
    const T nearest = T(stored);
    return double(nearest) > stored ? std::nextafter(nearest, std::numeric_limits<T>::lowest())
                                    : nearest;
  } else {
    constexpr double kHighest = std::numeric_limits<T>::max();
    return T(std::clamp(std::floor(stored + 1e-9), 0.0, kHighest));
  }
}

}  // namespace cutaway
