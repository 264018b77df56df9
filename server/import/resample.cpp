#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stop_token>
#include <type_traits>

#include "core/progress.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

namespace {

constexpr double kUncovered = std::numeric_limits<double>::quiet_NaN();

/// A tap between two pixels of a row or column; `inside` is false beyond its ends.
struct Tap {
  int index = 0;
  double fraction = 0.0;
  bool inside = false;
};

Tap tap_at(double position, int size) {
  constexpr double kRounding = 1e-6;
  if (!(position >= -kRounding && position <= size - 1 + kRounding)) return {};
  const double clamped = std::clamp(position, 0.0, static_cast<double>(size - 1));
  const int index = std::min(static_cast<int>(clamped), size - 2);
  return {index, clamped - index, true};
}

template <typename T>
bool is_nan(T value) {
  return std::isnan(static_cast<double>(value));
}

template <typename T>
class SliceResampler {
 public:
  SliceResampler(const std::vector<T>& voxels, const SliceStack& stack, const GridPlan& plan,
                 double slope)
      : voxels_(voxels), size_px_(stack.size_px), plan_(plan) {
    // NaN, which has no order, comes last.
    const auto smallest = std::min_element(voxels.begin(), voxels.end(), [slope](T a, T b) {
      return (slope < 0 ? b < a : a < b) || (!is_nan(a) && is_nan(b));
    });
    outside_ = *smallest;
  }

  std::vector<T> run(const std::stop_token& stop) {
    const glm::ivec3 size = plan_.geometry.size_voxels;
    const std::size_t slice_voxels = std::size_t(size.x) * size.y;
    std::vector<T> result(slice_voxels * size.z, outside_);
    for (int k = 0; k < size.z; ++k) {
      throw_if_cancelled(stop);
      blend_slices(k, std::span(result).subspan(slice_voxels * k, slice_voxels));
    }
    return result;
  }

 private:
  void blend_slices(int k, std::span<T> output) {
    const std::size_t above = slice_at_or_above(k);
    const std::size_t below = above > 0 ? above - 1 : above;
    const double low = plan_.placements[below].height;
    const double high = plan_.placements[above].height;
    const double weight = high > low ? std::clamp((k - low) / (high - low), 0.0, 1.0) : 0.0;
    const std::vector<double>& lower = shifted(lower_, below);
    const std::vector<double>& upper = shifted(upper_, above);
    for (std::size_t i = 0; i < output.size(); ++i) {
      const double value = blend(lower[i], upper[i], weight);
      if (!std::isnan(value)) output[i] = to_stored(value);
    }
  }

  /// An end of no weight counts for nothing, so that its uncovered pixels do not blank the other
  /// slice.
  static double blend(double lower, double upper, double weight) {
    constexpr double kRounding = 1e-6;
    if (weight <= kRounding) return lower;
    if (weight >= 1 - kRounding) return upper;
    return lower + (upper - lower) * weight;
  }

  static T to_stored(double value) {
    if constexpr (std::is_integral_v<T>) return static_cast<T>(std::lround(value));
    return static_cast<T>(value);
  }

  std::size_t slice_at_or_above(int k) const {
    const auto found =
        std::find_if(plan_.placements.begin(), plan_.placements.end(),
                     [k](const SlicePlacement& placement) { return placement.height >= k; });
    if (found == plan_.placements.end()) return plan_.placements.size() - 1;
    return static_cast<std::size_t>(found - plan_.placements.begin());
  }

  struct Shifted {
    std::size_t slice = std::numeric_limits<std::size_t>::max();
    std::vector<double> values;
  };

  const std::vector<double>& shifted(Shifted& cache, std::size_t slice) {
    if (cache.slice != slice) shift_slice(cache, slice);
    return cache.values;
  }

  /// The slice's values at the pixels of the output grid, in its own plane.
  void shift_slice(Shifted& cache, std::size_t slice) {
    const glm::ivec3 size = plan_.geometry.size_voxels;
    const glm::dvec2 shift = plan_.placements[slice].shift_px;
    const T* pixels = voxels_.data() + std::size_t(size_px_.x) * size_px_.y * slice;
    cache.slice = slice;
    cache.values.assign(std::size_t(size.x) * size.y, kUncovered);
    for (int j = 0; j < size.y; ++j) {
      const Tap row = tap_at(j - shift.y, size_px_.y);
      if (!row.inside) continue;
      for (int i = 0; i < size.x; ++i) {
        const Tap column = tap_at(i - shift.x, size_px_.x);
        if (column.inside)
          cache.values[std::size_t(j) * size.x + i] = bilinear(pixels, row, column);
      }
    }
  }

  double bilinear(const T* pixels, const Tap& row, const Tap& column) const {
    const T* first = pixels + std::size_t(row.index) * size_px_.x + column.index;
    const T* second = first + size_px_.x;
    const auto along_row = [&](const T* p) {
      return static_cast<double>(p[0]) * (1 - column.fraction) +
             static_cast<double>(p[1]) * column.fraction;
    };
    return along_row(first) * (1 - row.fraction) + along_row(second) * row.fraction;
  }

  const std::vector<T>& voxels_;
  glm::ivec2 size_px_;
  const GridPlan& plan_;
  T outside_{};
  Shifted lower_;
  Shifted upper_;
};

}  // namespace

RawVoxels resample(const RawVoxels& slices, const SliceStack& stack, const GridPlan& plan,
                   double slope, std::stop_token stop) {
  return std::visit(
      [&]<typename T>(const std::vector<T>& voxels) -> RawVoxels {
        return SliceResampler<T>(voxels, stack, plan, slope).run(stop);
      },
      slices);
}

}  // namespace cutaway::reading
