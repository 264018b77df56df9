// How often each value occurs, and where to cut: starting values for surfaces of any volume.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "volume/volume.h"

namespace cutaway {

struct Histogram {
  ValueRange range;                   ///< of the usual values
  std::vector<std::uint64_t> counts;  ///< equal bins over `range`; strays in the first and the last
};

Histogram build_histogram(const Volume& volume, int bins);

/// Multi-level Otsu: the `levels` - 1 physical values that part the histogram into `levels` classes
/// of greatest between-class variance, ascending. levels is 2..4. Source: N. Otsu, "A Threshold
/// Selection Method from Gray-Level Histograms", IEEE Trans. SMC 9(1), 1979; P.-S. Liao et al., "A
/// Fast Algorithm for Multilevel Thresholding", JISE 17, 2001.
std::vector<double> otsu_thresholds(const Histogram& histogram, int levels);

/// Iso-values of an outer (context) and an inner (focus) surface where a volume's edges tell none:
/// by Otsu over its histogram.
struct SuggestedSurfaces {
  double outer_iso_value = 0.0;
  double inner_iso_value = 0.0;
};
SuggestedSurfaces suggest_surfaces(const Histogram& histogram);

/// The physical values from black to white by which a slice is drawn at first: the file's own
/// window; else CT in HU has the soft tissue's, 40 +- 200, and everything else what is left without
/// the darkest and the brightest hundredth of the voxels. Neither of the first two where it would
/// draw those in a few greys or in one.
ValueRange suggest_window(const VolumeDescription& description, const Histogram& histogram);

}  // namespace cutaway
