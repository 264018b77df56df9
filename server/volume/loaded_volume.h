// A volume together with everything derived from it once, at load.
#pragma once

#include <memory>

#include "volume/facts/findings.h"
#include "volume/histogram.h"
#include "volume/min_max_grid.h"
#include "volume/pyramid.h"

namespace cutaway {

/// Immutable and shared: sessions and the render thread hold it by shared_ptr<const LoadedVolume>.
struct LoadedVolume {
  Volume volume;
  MinMaxGrid min_max;
  std::vector<CoarseLevel> pyramid;
  Histogram histogram;
  Findings findings;
  /// Patient space: the body where it was found, else what reaches the outer iso-value, to a brick.
  BoundingBox material_bounds_mm;
};

std::shared_ptr<const LoadedVolume> derive_loaded_volume(Volume volume,
                                                         const ProgressSink& progress,
                                                         const std::stop_token& stop);

/// Voxels and what is derived from them, as they lie in memory.
std::uint64_t memory_bytes(const LoadedVolume& loaded);

}  // namespace cutaway
