#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stop_token>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/progress.h"
#include "core/released_pages.h"
#include "import/no_data.h"
#include "import/slice_grid.h"

namespace cutaway::reading {

namespace {

constexpr double kRounding = 1e-6;

/// Two neighbours along a line and what each of them weighs; none beyond the ends of `size`.
struct Taps {
  std::size_t index = 0;
  std::array<double, 2> weights{};
  bool inside = false;
};

Taps taps_at(double position, int size) {
  if (!(position >= -kRounding && position <= size - 1 + kRounding)) return {};
  const double clamped = std::clamp(position, 0.0, static_cast<double>(size - 1));
  const int index = std::min(static_cast<int>(clamped), size - 2);
  const double fraction = clamped - index;
  return {static_cast<std::size_t>(index), {1 - fraction, fraction}, true};
}

/// The mean of neighbours that have a value. Where more than half of the weight has none, it is the
/// number of the weightiest of those: a number that says "nothing" is handed on as it is, and never
/// a part of a value.
template <typename T>
class Mean {
 public:
  void add(T value, bool is_value, double weight) {
    if (is_value) {
      sum_ += weight * static_cast<double>(value);
      weight_ += weight;
    } else {
      nothing_weight_ += weight;
      if (weight > heaviest_) std::tie(heaviest_, nothing_) = std::pair(weight, value);
    }
  }

  T value() const {
    if (nothing_weight_ > weight_) return nothing_;
    const double mean = sum_ / weight_;
    if constexpr (std::is_integral_v<T>) return static_cast<T>(std::lround(mean));
    return static_cast<T>(mean);
  }

 private:
  double sum_ = 0.0;
  double weight_ = 0.0;
  double nothing_weight_ = 0.0;
  double heaviest_ = 0.0;
  T nothing_{};
};

template <typename T>
class SliceResampler {
 public:
  SliceResampler(std::vector<T>& voxels, const SliceStack& stack, const GridPlan& plan,
                 const Stored& stored)
      : voxels_(voxels),
        size_px_(stack.size_px),
        slice_voxels_(std::size_t(stack.size_px.x) * stack.size_px.y),
        plan_(plan),
        padding_(stored.padding),
        valid_(mixable_values(std::span<const T>(voxels), stored.slope, stored.intercept)),
        outside_(physically_smallest(voxels, stored.slope < 0)) {}

  /// Slice by slice, so that the new ones take memory only as the old ones give it back.
  std::vector<T> run(const std::stop_token& stop) {
    const glm::ivec3 size = plan_.geometry.size_voxels;
    const std::size_t slice_voxels = std::size_t(size.x) * size.y;
    std::vector<T> result;
    result.reserve(slice_voxels * size.z);
    for (int k = 0; k < size.z; ++k) {
      throw_if_cancelled(stop);
      result.resize(result.size() + slice_voxels, outside_);
      fill_slice(k, std::span(result).last(slice_voxels));
    }
    return result;
  }

 private:
  /// A slice of the stack that has weight in one of the grid.
  struct Part {
    std::size_t slice = 0;
    double weight = 0.0;
  };

  /// NaN, which has no order, comes last.
  static T physically_smallest(const std::vector<T>& voxels, bool falls) {
    const auto is_nan = [](T value) { return std::isnan(static_cast<double>(value)); };
    return *std::min_element(voxels.begin(), voxels.end(), [&](T a, T b) {
      return (falls ? b < a : a < b) || (!is_nan(a) && is_nan(b));
    });
  }

  void fill_slice(int k, std::span<T> output) {
    const std::array<Part, 2> parts = parts_at(k);
    release_before(parts[0].slice);
    const auto width = static_cast<std::size_t>(plan_.geometry.size_voxels.x);
    for (int j = 0; j < plan_.geometry.size_voxels.y; ++j)
      fill_row(parts, j, output.subspan(width * static_cast<std::size_t>(j), width));
  }

  /// An end of no weight counts for nothing, so that its uncovered pixels do not blank the other
  /// slice.
  std::array<Part, 2> parts_at(int k) const {
    const std::size_t above = slice_at_or_above(k);
    const std::size_t below = above > 0 ? above - 1 : above;
    const double low = plan_.placements[below].height;
    const double high = plan_.placements[above].height;
    const double weight = high > low ? std::clamp((k - low) / (high - low), 0.0, 1.0) : 0.0;
    if (weight <= kRounding) return {Part{below, 1.0}, Part{below, 0.0}};
    if (weight >= 1 - kRounding) return {Part{above, 1.0}, Part{above, 0.0}};
    return {Part{below, 1 - weight}, Part{above, weight}};
  }

  std::size_t slice_at_or_above(int k) const {
    const auto found =
        std::find_if(plan_.placements.begin(), plan_.placements.end(),
                     [k](const SlicePlacement& placement) { return placement.height >= k; });
    if (found == plan_.placements.end()) return plan_.placements.size() - 1;
    return static_cast<std::size_t>(found - plan_.placements.begin());
  }

  void release_before(std::size_t slice) {
    const std::size_t done = slice * slice_voxels_;
    if (done <= released_) return;
    release_pages(std::as_writable_bytes(std::span(voxels_).subspan(released_, done - released_)));
    released_ = done;
  }

  void fill_row(const std::array<Part, 2>& parts, int j, std::span<T> output) const {
    std::array<Taps, 2> rows;
    for (std::size_t p = 0; p < 2; ++p)
      rows[p] = taps_at(j - plan_.placements[parts[p].slice].shift_px.y, size_px_.y);
    if (!rows[0].inside || !rows[1].inside) return;
    for (std::size_t i = 0; i < output.size(); ++i) {
      Mean<T> mean;
      bool inside = true;
      for (std::size_t p = 0; p < 2 && inside; ++p)
        inside = parts[p].weight == 0.0 || add(parts[p], rows[p], i, mean);
      if (inside) output[i] = mean.value();
    }
  }

  /// False where the slice does not reach there.
  bool add(const Part& part, const Taps& rows, std::size_t i, Mean<T>& mean) const {
    const double shift = plan_.placements[part.slice].shift_px.x;
    const Taps columns = taps_at(static_cast<double>(i) - shift, size_px_.x);
    if (!columns.inside) return false;
    const auto width = static_cast<std::size_t>(size_px_.x);
    for (std::size_t row = 0; row < 2; ++row) {
      const std::size_t first =
          part.slice * slice_voxels_ + (rows.index + row) * width + columns.index;
      for (std::size_t column = 0; column < 2; ++column) {
        const double weight = part.weight * rows.weights[row] * columns.weights[column];
        if (weight > 0) add(first + column, weight, mean);
      }
    }
    return true;
  }

  void add(std::size_t index, double weight, Mean<T>& mean) const {
    const T value = voxels_[index];
    mean.add(value, valid_.holds(value) && !(padding_ && padding_->holds(index)), weight);
  }

  std::vector<T>& voxels_;
  glm::ivec2 size_px_;
  std::size_t slice_voxels_;
  const GridPlan& plan_;
  const PaddingMask* padding_;
  ValidValues<T> valid_;
  T outside_;
  std::size_t released_ = 0;
};

}  // namespace

RawVoxels resample(RawVoxels slices, const SliceStack& stack, const GridPlan& plan,
                   const Stored& stored, std::stop_token stop) {
  return std::visit(
      [&]<typename T>(std::vector<T>& voxels) -> RawVoxels {
        return SliceResampler<T>(voxels, stack, plan, stored).run(stop);
      },
      slices);
}

}  // namespace cutaway::reading
