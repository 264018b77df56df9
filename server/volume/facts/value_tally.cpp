#include "volume/facts/value_tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "volume/parallel.h"

namespace cutaway {

namespace {

constexpr std::size_t kMostTallied = std::size_t{1} << 18;
constexpr double kGoldenStep = 0.6180339887498949;

void add(ValueTally& tally, double value, std::uint64_t count) {
  tally.total += count;
  if (!tally.values.empty() && tally.values.back() == value) {
    tally.counts.back() += count;
    return;
  }
  tally.values.push_back(value);
  tally.counts.push_back(count);
}

/// Each chunk on its own: sums of integers do not depend on the order.
std::vector<std::uint64_t> count_stored(const std::vector<std::uint16_t>& voxels) {
  constexpr std::size_t kValues = std::numeric_limits<std::uint16_t>::max() + 1;
  const int chunks = std::max(1, default_thread_count());
  std::vector<std::vector<std::uint64_t>> counts(chunks);
  const auto count_chunk = [&](int chunk) {
    counts[chunk].resize(kValues);
    const std::size_t begin = voxels.size() * chunk / chunks;
    const std::size_t end = voxels.size() * (chunk + 1) / chunks;
    for (std::size_t i = begin; i < end; ++i) ++counts[chunk][voxels[i]];
  };
  run_parallel({.count = chunks, .turn = count_chunk, .progress = {}}, {});
  for (int chunk = 1; chunk < chunks; ++chunk)
    std::transform(counts[0].begin(), counts[0].end(), counts[chunk].begin(), counts[0].begin(),
                   std::plus<>());
  return std::move(counts[0]);
}

ValueTally tally(const Volume& volume, const std::vector<std::uint16_t>& voxels) {
  ValueTally tally;
  const std::vector<std::uint64_t> counts = count_stored(voxels);
  for (std::size_t stored = 0; stored < counts.size(); ++stored) {
    if (counts[stored] > 0)
      add(tally, double(stored) * volume.value_scale + volume.value_offset, counts[stored]);
  }
  return tally;
}

ValueTally tally(const Volume& volume, const std::vector<float>& voxels) {
  std::vector<double> samples(std::min(voxels.size(), kMostTallied));
  const bool all = samples.size() == voxels.size();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double turn = double(i) * kGoldenStep;
    const auto at = std::size_t((turn - std::floor(turn)) * double(voxels.size()));
    samples[i] = double(voxels[all ? i : at]) * volume.value_scale + volume.value_offset;
  }
  std::sort(samples.begin(), samples.end());
  ValueTally tally;
  for (const double value : samples) add(tally, value, 1);
  return tally;
}

}  // namespace

double ValueTally::quantile(double share) const {
  double below = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    below += double(counts[i]);
    if (below > share * double(total)) return values[i];
  }
  return values.empty() ? 0.0 : values.back();
}

std::size_t ValueTally::mode() const {
  return std::size_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

ValueTally tally_values(const Volume& volume) {
  return std::visit([&](const auto& voxels) { return tally(volume, voxels); }, volume.voxels);
}

ValueTally within(const ValueTally& tally, const ValueRange& range) {
  ValueTally inner;
  for (std::size_t i = 0; i < tally.values.size(); ++i) {
    if (tally.values[i] >= range.minimum && tally.values[i] <= range.maximum)
      add(inner, tally.values[i], tally.counts[i]);
  }
  return inner.values.empty() ? tally : inner;
}

namespace {

constexpr double kRare = 0.0005;  // share at each end
constexpr double kSentinelShare = 0.005;
constexpr double kSentinelGap = 0.05;  // of the others' range
constexpr std::size_t kFewestValues = 4;

ValueTally without(const ValueTally& tally, std::size_t place) {
  ValueTally rest = tally;
  rest.total -= tally.counts[place];
  rest.values.erase(rest.values.begin() + std::ptrdiff_t(place));
  rest.counts.erase(rest.counts.begin() + std::ptrdiff_t(place));
  return rest;
}

ValueRange usual_range(const ValueTally& tally) {
  return {tally.quantile(kRare), tally.quantile(1.0 - kRare)};
}

/// Whether the first or the last value stands apart from the rest.
bool is_sentinel(const ValueTally& tally, std::size_t place, const ValueTally& rest) {
  if (tally.share(place) < kSentinelShare) return false;
  const ValueRange others = usual_range(rest);
  const double next = place == 0 ? rest.values.front() : rest.values.back();
  return std::abs(next - tally.values[place]) > kSentinelGap * (others.maximum - others.minimum);
}

}  // namespace

RobustRange robust_range(const ValueTally& tally) {
  RobustRange robust;
  ValueTally left = tally;
  for (const bool at_front : {true, false}) {
    if (left.values.size() < kFewestValues) break;
    const std::size_t place = at_front ? 0 : left.values.size() - 1;
    ValueTally rest = without(left, place);
    if (!is_sentinel(left, place, rest)) continue;
    robust.sentinels.push_back(left.values[place]);
    left = std::move(rest);
  }
  robust.range = usual_range(left);
  if (!(robust.range.maximum > robust.range.minimum) && !left.values.empty())
    robust.range = {left.values.front(), left.values.back()};
  return robust;
}

}  // namespace cutaway
