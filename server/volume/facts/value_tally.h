// Which values a volume has, and how often: what its range and its kind are told from.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/volume.h"

namespace cutaway {

/// Physical values, ascending and distinct, with how many voxels (of those looked at) hold each.
/// All voxels of 16-bit volumes; of floats at most 2^18 from everywhere, the same ones each time.
struct ValueTally {
  std::vector<double> values;
  std::vector<std::uint64_t> counts;
  std::uint64_t total = 0;

  /// The value below which a share (0..1) of the voxels lies.
  double quantile(double share) const;
  /// Place of the most frequent value.
  std::size_t mode() const;
  double share(std::size_t place) const { return double(counts[place]) / double(total); }
};

ValueTally tally_values(const Volume& volume);

/// Without the values beyond a range, which are not all.
ValueTally within(const ValueTally& tally, const ValueRange& range);

/// The values without the voxels at the ends that measure nothing or are rare.
struct RobustRange {
  ValueRange range;  ///< 0.05 to 99.95 % of what is left without the sentinels
  std::vector<double> sentinels;
};

/// A sentinel is the lowest or the highest value where it fills at least half a hundredth of the
/// volume and lies more than a twentieth of the others' range from the next: a scanner's padding.
/// A volume of fewer than four values has none.
RobustRange robust_range(const ValueTally& tally);

}  // namespace cutaway
