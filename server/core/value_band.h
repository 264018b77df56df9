// A range of a volume's values: what a branch takes for its material.
#pragma once

#include <limits>

namespace cutaway {

/// All values above `lower` and below `upper`, both ends excluded; physical values. Without an
/// upper end its border is an iso-surface.
struct ValueBand {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return value > lower && value < upper; }
  /// -1 below the band, 0 in it, 1 above.
  int side(double value) const { return value <= lower ? -1 : value >= upper ? 1 : 0; }
  bool has_upper_end() const { return upper < std::numeric_limits<double>::infinity(); }
  bool operator==(const ValueBand&) const = default;
};

}  // namespace cutaway
