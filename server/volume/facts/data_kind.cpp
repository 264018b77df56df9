#include "volume/facts/data_kind.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cutaway {

namespace {

constexpr std::size_t kMostPlaces = std::size_t{1} << 17;
constexpr double kGoldenTurn = 0.6180339887498949;

struct Pairs {
  std::uint64_t without_mode = 0;
  std::uint64_t equal = 0;
  std::uint64_t all = 0;
  double squared_differences = 0.0;
  double sum = 0.0;
  double squares = 0.0;
};

void take(Pairs& pairs, double a, double b, double mode, const ValueRange& robust) {
  if (a != mode && b != mode) {
    ++pairs.without_mode;
    if (a == b) ++pairs.equal;
  }
  a = std::clamp(a, robust.minimum, robust.maximum);
  b = std::clamp(b, robust.minimum, robust.maximum);
  ++pairs.all;
  pairs.squared_differences += (a - b) * (a - b);
  pairs.sum += a;
  pairs.squares += a * a;
}

glm::ivec3 place(std::size_t i, std::size_t places, glm::ivec3 size) {
  const auto voxels = std::size_t(size.x) * size.y * size.z;
  const double turn = double(i) * kGoldenTurn;
  const auto at = places == voxels ? i : std::size_t((turn - std::floor(turn)) * double(voxels));
  return {int(at % size.x), int(at / size.x % size.y), int(at / size.x / size.y)};
}

}  // namespace

NeighbourFacts neighbour_facts(const Volume& volume, const ValueTally& tally,
                               const ValueRange& robust) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  const std::size_t places = std::min(kMostPlaces, std::size_t(size.x) * size.y * size.z);
  const double mode = tally.values[tally.mode()];
  Pairs pairs;
  for (std::size_t i = 0; i < places; ++i) {
    const glm::ivec3 here = place(i, places, size);
    const double value = value_at(volume, here);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 next = here;
      if (++next[axis] < size[axis]) take(pairs, value, value_at(volume, next), mode, robust);
    }
  }
  if (pairs.all == 0) return {};
  const double n = double(pairs.all);
  const double variance = pairs.squares / n - (pairs.sum / n) * (pairs.sum / n);
  return {
      .equal_share = double(pairs.equal) / double(std::max<std::uint64_t>(pairs.without_mode, 1)),
      .independence = variance > 0.0 ? pairs.squared_differences / n / (2.0 * variance) : 0.0};
}

namespace {

constexpr std::size_t kMostLabels = 4096;
constexpr double kEqualLabels = 0.9;
constexpr double kIndependent = 0.8;

bool are_integers(const ValueTally& tally) {
  return std::ranges::all_of(tally.values,
                             [](double v) { return std::abs(v - std::round(v)) < 1e-6; });
}

/// Both signs about alike, and most of it near 0 or spread on both sides of it.
bool is_signed_map(const ValueTally& tally) {
  const double low = tally.quantile(0.01);
  const double high = tally.quantile(0.99);
  if (!(low < 0.0 && high > 0.0) || -low / high <= 0.2 || -low / high >= 5.0) return false;
  const std::size_t mode = tally.mode();
  if (tally.values[mode] == 0.0 && tally.share(mode) >= 0.2) return true;
  const double first = tally.quantile(0.25);
  const double third = tally.quantile(0.75);
  return first < 0.0 && third > 0.0 && -first / third > 1.0 / 3.0 && -first / third < 3.0;
}

DataKind kind_of_scale(const VolumeDescription& description) {
  if (description.units == "HU") return DataKind::hounsfield;
  if (description.modality == "MR") return DataKind::mr;
  if (description.modality == "PT" || description.modality == "NM") return DataKind::emission;
  return DataKind::unknown;
}

}  // namespace

DataKind data_kind(const VolumeDescription& description, const ValueTally& tally,
                   const RobustRange& robust, const NeighbourFacts& neighbours) {
  const std::size_t values = tally.values.size() - robust.sentinels.size();
  if (values <= 1) return DataKind::constant;
  if (values == 2) return DataKind::two_valued;
  const DataKind scale = kind_of_scale(description);
  const bool may_be_names = scale != DataKind::hounsfield || tally.values.front() >= 0.0;
  if (may_be_names && tally.values.size() <= kMostLabels && are_integers(tally) &&
      neighbours.equal_share >= kEqualLabels)
    return DataKind::labels;
  if (scale == DataKind::hounsfield) return scale;
  if (is_signed_map(tally)) return DataKind::signed_map;
  return neighbours.independence >= kIndependent ? DataKind::noise : scale;
}

const char* name_of(DataKind kind) {
  static constexpr std::array kNames{"CT in Hounsfield units",
                                     "MR",
                                     "emission (PET, SPECT)",
                                     "values of unknown units",
                                     "a map of both signs",
                                     "two values (a mask)",
                                     "labels",
                                     "noise",
                                     "one value"};
  return kNames[std::size_t(kind)];
}

}  // namespace cutaway
