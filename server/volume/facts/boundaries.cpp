#include "volume/facts/boundaries.h"

#include <algorithm>

namespace cutaway {

namespace {

using Curve = EdgeStatistics::Curve;

constexpr double kLeastArea = 0.1;
constexpr double kLeastStrength = 1.0 / 3.0;
constexpr double kInnerArea = 0.02;
constexpr double kAboveOuter = 0.15;  // of the range

/// A peak's place, not its noise: a Gaussian of four bins.
Curve calm(Curve curve) {
  constexpr int kPasses = 24;
  for (int pass = 0; pass < kPasses; ++pass) {
    Curve next = curve;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
      next[i] = (curve[i - 1] + curve[i] + curve[i + 1]) / 3.0;
    curve = next;
  }
  return curve;
}

/// Calm.
Curve product(const Curve& a, const Curve& b) {
  Curve out{};
  std::ranges::transform(a, b, out.begin(), std::multiplies<>());
  return calm(out);
}

double largest(const Curve& curve) { return *std::ranges::max_element(curve); }

/// The greatest of the curve's peaks from `first` on whose surface is not too small.
std::optional<int> greatest_peak(const Curve& curve, const Curve& area, int first) {
  const double least_area = kInnerArea * largest(area);
  std::optional<int> best;
  for (const int peak : peaks(curve)) {
    if (peak < first || area[peak] < least_area) continue;
    if (!best || curve[peak] > curve[*best]) best = peak;
  }
  return best;
}

}  // namespace

std::optional<double> outer_boundary(const EdgeStatistics& edges) {
  const double least_area = kLeastArea * largest(edges.area_mm2);
  const Curve strength = calm(edges.strength_per_mm);
  std::vector<int> found = peaks(strength);
  std::erase_if(found, [&](int peak) { return edges.area_mm2[peak] < least_area; });
  double strongest = 0.0;
  for (const int peak : found) strongest = std::max(strongest, strength[peak]);
  for (const int peak : found) {
    if (strength[peak] >= kLeastStrength * strongest) return edges.value_of(peak);
  }
  const std::vector<int> of_means = peaks(edges.mean_gradient_per_mm);
  if (of_means.empty()) return std::nullopt;
  return edges.value_of(of_means.front());
}

std::optional<double> inner_boundary(const EdgeStatistics& inside, double outer) {
  const double range = inside.range.maximum - inside.range.minimum;
  const int first = inside.bin_of(outer + kAboveOuter * range);
  const Curve flux = product(inside.area_mm2, inside.strength_per_mm);
  std::optional<int> peak = greatest_peak(flux, inside.area_mm2, first);
  if (!peak) peak = greatest_peak(calm(inside.strength_per_mm), inside.area_mm2, first);
  if (!peak) return std::nullopt;
  return inside.value_of(*peak);
}

namespace {

/// What lies within 50 HU from a value on.
struct Stretch {
  double cells = 0.0;
  double mean_gradient = 0.0;  ///< of its cells
  double strength = 0.0;       ///< of its surfaces
};

Stretch stretch_from(const EdgeStatistics& edges, double value) {
  constexpr double kWidth = 50.0;
  Stretch stretch;
  double area = 0.0;
  const int last = std::max(edges.bin_of(value) + 1, edges.bin_of(value + kWidth));
  for (int bin = edges.bin_of(value); bin < last; ++bin) {
    stretch.cells += edges.cells[bin];
    stretch.mean_gradient += edges.cells[bin] * edges.mean_gradient_per_mm[bin];
    stretch.strength += edges.area_mm2[bin] * edges.strength_per_mm[bin];
    area += edges.area_mm2[bin];
  }
  stretch.mean_gradient /= std::max(stretch.cells, 1.0);
  stretch.strength /= std::max(area, 1e-9);
  return stretch;
}

/// Lumen is a material of its own: common, more so than what is less dense, and calm inside, which
/// bone is not.
std::optional<double> lumen(const EdgeStatistics& inside) {
  constexpr double kCommon = 0.03;  // of the tissue
  constexpr double kMoreThanBelow = 1.5;
  constexpr double kCalm = 0.5;
  double tissue = 0.0;
  for (int bin = inside.bin_of(-200.0); bin < EdgeStatistics::kBins; ++bin)
    tissue += inside.cells[bin];
  double fewest = stretch_from(inside, 150.0).cells;
  std::optional<double> found;
  for (double value = 200.0; value <= 500.0; value += 25.0) {
    const Stretch here = stretch_from(inside, value);
    fewest = std::min(fewest, here.cells);
    const bool is_material =
        here.cells >= kCommon * tissue && here.cells >= kMoreThanBelow * fewest;
    if (!found && is_material && here.mean_gradient <= kCalm * here.strength) found = value + 25.0;
  }
  return found;
}

}  // namespace

std::optional<double> contrast_boundary(const EdgeStatistics& inside) {
  constexpr double kLowest = 150.0;
  if (inside.range.maximum < kLowest) return std::nullopt;
  const std::optional<double> filled = lumen(inside);
  if (!filled) return std::nullopt;
  const Curve flux = product(inside.area_mm2, inside.strength_per_mm);
  std::optional<int> best;
  for (const int peak : peaks(flux)) {
    const double value = inside.value_of(peak);
    if (value < kLowest || value > *filled) continue;
    if (!best || flux[peak] > flux[*best]) best = peak;
  }
  // Blood meets tissue half way between the two; what begins higher lies within a shell of its own.
  constexpr double kHalfWay = 0.75;
  if (!best || inside.value_of(*best) > kHalfWay * *filled) return std::nullopt;
  return inside.value_of(*best);
}

}  // namespace cutaway
