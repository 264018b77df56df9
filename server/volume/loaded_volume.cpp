#include "volume/loaded_volume.h"

#include <algorithm>
#include <utility>

#include "core/check.h"

namespace cutaway {

namespace {

/// Small bricks follow a surface more closely, but their maps are computed anew for each iso-value:
/// as many for a large volume as for a small one.
int brick_size(glm::ivec3 size_voxels) {
  constexpr int kMostBricksAlongEdge = 80;
  const int longest = std::max({size_voxels.x, size_voxels.y, size_voxels.z});
  return longest <= 4 * kMostBricksAlongEdge ? 4 : 8;
}

constexpr int kHistogramBins = 1024;
constexpr double kMinMaxShare =
    0.4;  ///< of the stage's progress; pyramid and findings are the rest

BoundingBox material_bounds_mm(const LoadedVolume& loaded) {
  if (loaded.findings.body) return loaded.findings.body->body_bounds_mm;
  return bounds_reaching_mm(loaded.min_max, loaded.volume.geometry, loaded.findings.outer.value);
}

}  // namespace

std::shared_ptr<const LoadedVolume> derive_loaded_volume(Volume volume,
                                                         const ProgressSink& progress,
                                                         const std::stop_token& stop) {
  check(volume.value_scale > 0.0, "stored values rise with the physical ones");
  const ProgressSink share = [&](LoadStage stage, double fraction) {
    if (progress) progress(stage, fraction * kMinMaxShare);
  };
  auto loaded = std::make_shared<LoadedVolume>();
  loaded->volume = std::move(volume);
  loaded->min_max = build_min_max_grid(
      loaded->volume, brick_size(loaded->volume.geometry.size_voxels), share, stop);
  loaded->pyramid = build_pyramid(loaded->volume, stop);
  loaded->histogram = build_histogram(loaded->volume, kHistogramBins);
  throw_if_cancelled(stop);
  loaded->findings = find_out(loaded->volume, stop);
  loaded->material_bounds_mm = material_bounds_mm(*loaded);
  if (progress) progress(LoadStage::min_max, 1.0);
  return loaded;
}

std::uint64_t memory_bytes(const LoadedVolume& loaded) {
  const MinMaxGrid& grid = loaded.min_max;
  return byte_size(loaded.volume) + byte_size(loaded.pyramid) +
         ((grid.minimum.size() + grid.maximum.size()) * sizeof(float)) +
         (loaded.histogram.counts.size() * sizeof(std::uint64_t)) + byte_size(loaded.findings);
}

}  // namespace cutaway
