#include "volume/histogram.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>
#include <string>

#include "core/check.h"
#include "volume/parallel.h"
#include "volume/usual_values.h"

namespace cutaway {

namespace {

constexpr std::size_t kChunkVoxels = std::size_t(1) << 22;

int bin_of(const Histogram& histogram, double value) {
  const double width = histogram.range.maximum - histogram.range.minimum;
  if (!(width > 0.0)) return 0;
  const double bins = double(histogram.counts.size());
  const double bin = (value - histogram.range.minimum) / width * bins;
  return int(std::clamp(bin, 0.0, bins - 1.0));
}

using Counts = std::vector<std::uint64_t>;

/// Counts each chunk on its own and adds them up: sums of integers do not depend on the order.
template <typename T, typename BinOf>
Counts count_parallel(std::span<const T> values, std::size_t bins, const BinOf& bin) {
  Counts total(bins);
  std::mutex mutex;
  const auto count_chunk = [&](int chunk) {
    Counts counts(bins);
    const std::size_t begin = chunk * kChunkVoxels;
    for (const T value : values.subspan(begin, std::min(kChunkVoxels, values.size() - begin))) {
      ++counts[bin(value)];
    }
    const std::lock_guard lock(mutex);
    std::transform(total.begin(), total.end(), counts.begin(), total.begin(), std::plus<>());
  };
  const std::size_t chunks = (values.size() + kChunkVoxels - 1) / kChunkVoxels;
  run_parallel({.count = int(chunks), .turn = count_chunk, .progress = {}}, {});
  return total;
}

/// Counts the 65536 stored values first: that needs no arithmetic per voxel.
void count(const Volume& volume, std::span<const std::uint16_t> voxels, Histogram& histogram) {
  constexpr std::size_t kValues = std::numeric_limits<std::uint16_t>::max() + 1;
  const Counts counts = count_parallel(voxels, kValues, [](std::uint16_t v) { return v; });
  for (std::size_t stored = 0; stored < kValues; ++stored) {
    const double value = double(stored) * volume.value_scale + volume.value_offset;
    histogram.counts[bin_of(histogram, value)] += counts[stored];
  }
}

void count(const Volume& volume, std::span<const float> voxels, Histogram& histogram) {
  histogram.counts = count_parallel(voxels, histogram.counts.size(), [&](float stored) {
    return bin_of(histogram, double(stored) * volume.value_scale + volume.value_offset);
  });
}

}  // namespace

Histogram build_histogram(const Volume& volume, int bins) {
  check(bins >= 1, "bins is " + std::to_string(bins));
  Histogram histogram{.range = usual_values(volume).range, .counts = Counts(bins)};
  std::visit([&](const auto& voxels) { count(volume, std::span(voxels), histogram); },
             volume.voxels);
  return histogram;
}

namespace {

/// The value below which a share of the voxels lies, to a bin.
double quantile(const Histogram& histogram, double share) {
  const std::uint64_t all =
      std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
  const double width = histogram.range.maximum - histogram.range.minimum;
  double below = 0.0;
  std::size_t bin = 0;
  while (bin < histogram.counts.size() &&
         below + double(histogram.counts[bin]) <= share * double(all))
    below += double(histogram.counts[bin++]);
  return histogram.range.minimum + width * (double(bin) + 0.5) / double(histogram.counts.size());
}

/// How many grey levels the middle of the values must get at least; of 256.
constexpr double kFewestLevels = 5.0;

/// Whether a window shows anything of the values: it is not beside their middle, and not so wide
/// that all of it is one grey.
bool shows(const ValueRange& window, const ValueRange& middle) {
  const double width = window.maximum - window.minimum;
  return width > 0.0 && window.minimum < middle.maximum && middle.minimum < window.maximum &&
         middle.maximum - middle.minimum >= kFewestLevels / 256.0 * width;
}

}  // namespace

ValueRange suggest_window(const VolumeDescription& description, const Histogram& histogram) {
  constexpr ValueRange kSoftTissueHu{-160.0, 240.0};
  const ValueRange middle{quantile(histogram, 0.01), quantile(histogram, 0.99)};
  if (!(middle.maximum > middle.minimum)) {
    if (description.window) return *description.window;
    if (histogram.range.maximum > histogram.range.minimum) return histogram.range;
    return {histogram.range.minimum - 0.5, histogram.range.minimum + 0.5};
  }
  if (description.window && shows(*description.window, middle)) return *description.window;
  if (description.units == "HU" && shows(kSoftTissueHu, middle)) return kSoftTissueHu;
  return middle;
}

}  // namespace cutaway
