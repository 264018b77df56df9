#include "volume/usual_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cutaway {

namespace {

constexpr std::size_t kMostSamples = std::size_t{1} << 18;
constexpr double kShareOfStrays = 0.005;  // at each end
constexpr double kFarRanges = 8.0;        // times the others' range is far from them

/// Values as stored, ascending. All of a small volume's; of a large one's some from everywhere,
/// which no row length can fall into step with (multiples of the golden ratio, modulo 1).
template <typename T>
std::vector<double> sorted_samples(const std::vector<T>& voxels) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  std::vector<double> samples(std::min(voxels.size(), kMostSamples));
  const bool all = samples.size() == voxels.size();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double turn = double(i) * kGoldenRatio;
    const auto at = std::size_t((turn - std::floor(turn)) * double(voxels.size()));
    samples[i] = double(voxels[all ? i : at]);
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// First and last place of the longest run of equal values.
std::pair<std::size_t, std::size_t> most_frequent(const std::vector<double>& sorted) {
  std::pair<std::size_t, std::size_t> longest{0, 1};
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    if (end - begin > longest.second - longest.first) longest = {begin, end};
  }
  return longest;
}

/// What a value must not leave, to be no stray. Background may be nearly all of a volume, so it
/// does not count among those of which a share is set aside.
ValueRange fence_around(std::vector<double> sorted) {
  constexpr double kEverywhere = std::numeric_limits<double>::infinity();
  const auto [begin, end] = most_frequent(sorted);
  const double background = sorted[begin];
  sorted.erase(sorted.begin() + std::ptrdiff_t(begin), sorted.begin() + std::ptrdiff_t(end));
  if (sorted.empty()) return {-kEverywhere, kEverywhere};
  const auto set_aside = std::size_t(kShareOfStrays * double(sorted.size()));
  const double low = std::min(background, sorted[set_aside]);
  const double high = std::max(background, sorted[sorted.size() - 1 - set_aside]);
  if (!(high > low)) return {-kEverywhere, kEverywhere};
  const double far = kFarRanges * (high - low);
  return {low - far, high + far};
}

template <typename T>
UsualValues values_within(const std::vector<T>& voxels, const ValueRange& fence) {
  UsualValues usual{.range = {fence.maximum, fence.minimum}};
  for (const T voxel : voxels) {
    const double value = double(voxel);
    const bool inside = value >= fence.minimum && value <= fence.maximum;
    usual.strays += inside ? 0 : 1;
    usual.range.minimum = inside ? std::min(usual.range.minimum, value) : usual.range.minimum;
    usual.range.maximum = inside ? std::max(usual.range.maximum, value) : usual.range.maximum;
  }
  return usual;
}

}  // namespace

UsualValues usual_values(const Volume& volume) {
  const ValueRange all{volume.nothing_value.value_or(volume.value_range.minimum),
                       volume.value_range.maximum};
  return std::visit(
      [&](const auto& voxels) {
        const auto physical = [&](ValueRange stored) {
          return ValueRange{stored.minimum * volume.value_scale + volume.value_offset,
                            stored.maximum * volume.value_scale + volume.value_offset};
        };
        const ValueRange fence = fence_around(sorted_samples(voxels));
        const ValueRange limits = physical(fence);
        if (limits.minimum <= all.minimum && all.maximum <= limits.maximum)
          return UsualValues{.range = all};
        UsualValues usual = values_within(voxels, fence);
        usual.range = physical(usual.range);
        return usual;
      },
      volume.voxels);
}

}  // namespace cutaway
