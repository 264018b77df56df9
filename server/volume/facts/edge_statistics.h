// Where boundaries between materials are, over the values: by how strong and how large the
// iso-surface at each value is.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "volume/facts/calm_grid.h"

namespace cutaway {

/// Over 256 equal bins of the robust range, smoothed over three. By the coarea formula the sum of
/// |gradient| over a bin's cells, times a cell's volume and over the bin's width, is the area of
/// the iso-surface there. Sources: C. Scheidegger et al., "Revisiting Histograms and Isosurface
/// Statistics", IEEE TVCG 14(6), 2008; G. Kindlmann, J. Durkin, "Semi-Automatic Generation of
/// Transfer Functions for Direct Volume Rendering", VolVis 1998 (the mean over cells).
struct EdgeStatistics {
  static constexpr int kBins = 256;
  using Curve = std::array<double, kBins>;

  ValueRange range;
  Curve cells{};
  Curve area_mm2{};
  Curve strength_per_mm{};       ///< mean |gradient| over the surface
  Curve mean_gradient_per_mm{};  ///< mean |gradient| over the bin's cells

  double value_of(int bin) const {
    return range.minimum + (bin + 0.5) * (range.maximum - range.minimum) / kBins;
  }
  int bin_of(double value) const;
};

/// Which cells count.
struct EdgeCells {
  std::vector<std::uint8_t> inside;  ///< by their place in the grid; all where it is empty
  double least_per_mm = 0.0;         ///< weaker gradients are none
};

EdgeStatistics edge_statistics(const CalmGrid& grid, const ValueRange& range,
                               const EdgeCells& cells, const std::stop_token& stop);

/// The gradient that half of the cells (of 2^16 from everywhere) stay below: where a background
/// fills most of a volume, its noise.
double median_gradient_per_mm(const CalmGrid& grid);

/// Bins above both neighbours, from the lowest; a plateau counts once.
std::vector<int> peaks(const EdgeStatistics::Curve& curve);

}  // namespace cutaway
