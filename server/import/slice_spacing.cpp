#include "import/slice_spacing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr double kHeightTolerance = 0.05;  // of the slice distance
constexpr double kHeightToleranceMm = 0.011;
constexpr double kLargestHeightTolerance = 0.35;  // of the slice distance, whatever the digits
constexpr double kSmallestGap = 1e-3;             // of the slice distance
constexpr double kSameGap = 0.1;                  // of the smaller of two gaps
constexpr int kFewestOfASpacing = 3;              // gaps in a row that are no accident
constexpr double kLargestGapSlices = 4.5;  // in median slice distances: a gap of four still counts

std::vector<double> gaps_between(const std::vector<double>& heights) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights.size(); ++i) gaps.push_back(heights[i] - heights[i - 1]);
  return gaps;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool evenly_spaced(const std::vector<double>& heights, double step_mm, double position_mm) {
  const double by_digits =
      std::min(std::max(position_mm, kHeightToleranceMm), kLargestHeightTolerance * step_mm);
  const double tolerance = std::max(kHeightTolerance * step_mm, by_digits);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::abs(heights[k] - static_cast<double>(k) * step_mm) > tolerance) return false;
  }
  return true;
}

/// Gaps of one size in a row.
struct Spacing {
  double gap_mm = 0.0;
  int count = 0;
};

bool is_same_gap(double a, double b, double tolerance_mm) {
  return std::abs(a - b) <= std::max(kSameGap * std::min(a, b), tolerance_mm);
}

std::vector<Spacing> spacings_of(const std::vector<double>& gaps, double tolerance_mm) {
  std::vector<Spacing> spacings;
  for (const double gap : gaps) {
    if (!spacings.empty() && is_same_gap(gap, spacings.back().gap_mm, tolerance_mm)) {
      ++spacings.back().count;
    } else {
      spacings.push_back({gap, 1});
    }
  }
  return spacings;
}

/// A wide gap by itself is a hole; several in a row are a spacing.
void require_gaps(const std::filesystem::path& file, const std::vector<double>& gaps,
                  double typical_mm, double tolerance_mm) {
  const double smallest = *std::min_element(gaps.begin(), gaps.end());
  if (!(smallest > 0) || smallest < kSmallestGap * typical_mm) {
    refuse(file, "slices coincide or run back", "slices one behind the other",
           fmt::format("a step of {:.4g} mm", smallest));
  }
  for (const auto& [gap, count] : spacings_of(gaps, tolerance_mm)) {
    if (count >= kFewestOfASpacing || gap <= kLargestGapSlices * typical_mm) continue;
    refuse(file, "too many slices are missing in one place",
           fmt::format("gaps of at most {:.4g} mm", kLargestGapSlices * typical_mm),
           fmt::format("a gap of {:.4g} mm among slices {:.4g} mm apart", gap, typical_mm));
  }
}

/// The distances in which whole stretches of the stack were taken, the smallest first, each once.
std::vector<double> steady_gaps(const std::vector<Spacing>& spacings, double tolerance_mm) {
  std::vector<double> steady;
  for (const auto& [gap, count] : spacings) {
    const bool is_new = std::none_of(steady.begin(), steady.end(), [&](double other) {
      return is_same_gap(gap, other, tolerance_mm);
    });
    if (count >= kFewestOfASpacing && is_new) steady.push_back(gap);
  }
  std::sort(steady.begin(), steady.end());
  return steady;
}

/// Slices that a gap has room for, where its size says so and it is no spacing of its own.
int missing_in(const Spacing& spacing, double step_mm) {
  const double steps = spacing.gap_mm / step_mm;
  const bool is_whole = std::abs(steps - std::round(steps)) <= kSameGap * steps;
  if (spacing.count >= kFewestOfASpacing || !is_whole) return 0;
  return spacing.count * (static_cast<int>(std::lround(steps)) - 1);
}

std::string missing_in_words(int missing) {
  return missing == 1 ? "1 slice is missing" : fmt::format("{} slices are missing", missing);
}

std::string uneven_warning(const std::vector<double>& gaps, double step_mm, double tolerance_mm) {
  const auto [smallest, largest] = std::minmax_element(gaps.begin(), gaps.end());
  const std::vector<Spacing> spacings = spacings_of(gaps, tolerance_mm);
  const std::vector<double> steady = steady_gaps(spacings, tolerance_mm);
  int missing = 0;
  for (const auto& spacing : spacings) missing += missing_in(spacing, step_mm);
  std::string what = "slices are unevenly spaced";
  if (steady.size() > 1) {
    what =
        fmt::format("the distance between slices changes from {:.4g} to {:.4g} mm within the stack",
                    steady.front(), steady.back());
    if (missing > 0) what += ", and " + missing_in_words(missing);
  } else if (missing > 0) {
    what = missing_in_words(missing);
  }
  return fmt::format("{} ({:.4g} to {:.4g} mm apart); resampled to {:.4g} mm", what, *smallest,
                     *largest, step_mm);
}

/// The finest of the steady distances, so that resampling loses no slice of such a stretch.
double resampled_step_mm(const std::vector<double>& gaps, double typical_mm, double tolerance_mm) {
  const auto steady = steady_gaps(spacings_of(gaps, tolerance_mm), tolerance_mm);
  if (steady.size() < 2) return typical_mm;
  return std::max(steady.front(), typical_mm / kLargestGapSlices);
}

}  // namespace

SliceSpacing spacing_of(const std::filesystem::path& file, const std::vector<double>& heights_mm,
                        double tolerance_mm) {
  const std::vector<double> gaps = gaps_between(heights_mm);
  const double typical_mm = median(gaps);
  require_gaps(file, gaps, typical_mm, tolerance_mm);
  const double even_mm = heights_mm.back() / static_cast<double>(gaps.size());
  if (evenly_spaced(heights_mm, even_mm, tolerance_mm)) return {.step_mm = even_mm};
  const double step_mm = resampled_step_mm(gaps, typical_mm, tolerance_mm);
  return {
      .step_mm = step_mm, .is_even = false, .warning = uneven_warning(gaps, step_mm, tolerance_mm)};
}

}  // namespace cutaway::reading
