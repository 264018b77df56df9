#include "import/slice_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cutaway::reading {

namespace {

// Header decimals are often rounded to 0.1 or 0.01 mm; what they cannot explain is a real
// irregularity.
constexpr double kHeightTolerance = 0.05;  // of the slice distance
constexpr double kHeightToleranceMm = 0.011;
constexpr double kSmallestGap = 1e-3;  // of the slice distance
constexpr double kShiftTolerancePx = 0.1;
constexpr double kAxisTolerance = 1e-3;    // of length and of the cosine between axes
constexpr double kLargestGapSlices = 4.5;  // in median slice distances: a gap of four still counts

bool is_finite(glm::dvec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void require_spacing(const std::filesystem::path& file, glm::dvec2 spacing_mm) {
  const auto usable = [](double s) { return std::isfinite(s) && s > 0 && s < 1e4; };
  if (usable(spacing_mm.x) && usable(spacing_mm.y)) return;
  refuse(file, "the pixel spacing is not usable", "two numbers above 0 mm",
         fmt::format("{} and {}", spacing_mm.x, spacing_mm.y));
}

void require_axes(const std::filesystem::path& file, const SliceStack& stack) {
  const auto unit = [](glm::dvec3 axis) {
    return is_finite(axis) && std::abs(glm::length(axis) - 1) < kAxisTolerance;
  };
  if (!unit(stack.i_axis) || !unit(stack.j_axis)) {
    refuse(file, "the directions of rows and columns are not usable", "two vectors of length 1");
  }
  const double cosine = glm::dot(stack.i_axis, stack.j_axis);
  if (std::abs(cosine) > kAxisTolerance) {
    refuse(file, "rows and columns are not at right angles", "a cosine of 0 between them",
           number_in_words(cosine));
  }
}

void require_reach(const std::filesystem::path& file, glm::dvec3 position_mm) {
  if (!is_finite(position_mm)) refuse(file, "a slice position is not a finite number");
  if (is_within_reach(position_mm)) return;
  refuse(file, "the volume lies too far from the patient's origin to be looked at",
         fmt::format("at most {:g} m along each axis", kFarthestPosition_mm / 1000),
         fmt::format("a corner at {:.6g}, {:.6g}, {:.6g} mm", position_mm.x, position_mm.y,
                     position_mm.z));
}

/// Orthonormal; the sign of k follows the stack, so that a left-handed grid stays one.
glm::dmat3 right_axes(const SliceStack& stack) {
  const glm::dvec3 i = glm::normalize(stack.i_axis);
  const glm::dvec3 j = glm::normalize(stack.j_axis - i * glm::dot(i, stack.j_axis));
  const glm::dvec3 normal = glm::cross(i, j);
  const glm::dvec3 climb = stack.first_pixel_mm.back() - stack.first_pixel_mm.front();
  return {i, j, glm::dot(climb, normal) < 0 ? -normal : normal};
}

std::vector<double> heights_mm(const SliceStack& stack, const glm::dmat3& axes) {
  std::vector<double> heights;
  heights.reserve(stack.first_pixel_mm.size());
  for (const auto& corner : stack.first_pixel_mm) {
    heights.push_back(glm::dot(corner - stack.first_pixel_mm.front(), axes[2]));
  }
  return heights;
}

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

void require_gaps(const std::filesystem::path& file, const std::vector<double>& gaps,
                  double typical_mm) {
  const auto [smallest, largest] = std::minmax_element(gaps.begin(), gaps.end());
  if (!(*smallest > 0) || *smallest < kSmallestGap * typical_mm) {
    refuse(file, "slices coincide or run back", "slices one behind the other",
           fmt::format("a step of {:.4g} mm", *smallest));
  }
  if (*largest > kLargestGapSlices * typical_mm) {
    refuse(file, "too many slices are missing in one place",
           fmt::format("gaps of at most {:.4g} mm", kLargestGapSlices * typical_mm),
           fmt::format("a gap of {:.4g} mm among slices {:.4g} mm apart", *largest, typical_mm));
  }
}

bool evenly_spaced(const std::vector<double>& heights, double step_mm) {
  const double tolerance = std::max(kHeightTolerance * step_mm, kHeightToleranceMm);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (std::abs(heights[k] - static_cast<double>(k) * step_mm) > tolerance) return false;
  }
  return true;
}

std::string uneven_warning(const std::vector<double>& gaps, double step_mm) {
  const auto [smallest, largest] = std::minmax_element(gaps.begin(), gaps.end());
  int missing = 0;
  for (const double gap : gaps) missing += static_cast<int>(std::lround(gap / step_mm)) - 1;
  const std::string what = missing > 0 ? fmt::format("{} slices are missing", missing)
                                       : std::string("slices are unevenly spaced");
  return fmt::format("{} ({:.4g} to {:.4g} mm apart); resampled to {:.4g} mm", what, *smallest,
                     *largest, step_mm);
}

std::vector<glm::dvec2> shifts_px(const SliceStack& stack, const glm::dmat3& axes) {
  std::vector<glm::dvec2> shifts;
  shifts.reserve(stack.first_pixel_mm.size());
  for (const auto& corner : stack.first_pixel_mm) {
    const glm::dvec3 offset = corner - stack.first_pixel_mm.front();
    shifts.push_back(glm::dvec2(glm::dot(offset, axes[0]), glm::dot(offset, axes[1])) /
                     stack.pixel_spacing_mm);
  }
  return shifts;
}

/// Sets the slices' places along k and the spacing between slices; true where the grid has to be
/// resampled.
bool place_along_k(const std::filesystem::path& file, const std::vector<double>& heights,
                   GridPlan& plan) {
  const std::vector<double> gaps = gaps_between(heights);
  double step_mm = heights.back() / static_cast<double>(heights.size() - 1);
  const double typical_mm = median(gaps);
  require_gaps(file, gaps, typical_mm);
  const bool even = evenly_spaced(heights, step_mm);
  if (!even) {
    step_mm = typical_mm;
    plan.warnings.push_back(uneven_warning(gaps, step_mm));
  }
  for (std::size_t k = 0; k < heights.size(); ++k) {
    plan.placements[k].height = even ? static_cast<double>(k) : heights[k] / step_mm;
  }
  plan.geometry.spacing_mm.z = step_mm;
  // A last fraction of a step is kept: the grid reaches at least as far as the slices.
  plan.geometry.size_voxels.z =
      even ? static_cast<int>(heights.size())
           : static_cast<int>(std::ceil(heights.back() / step_mm - kHeightTolerance)) + 1;
  return !even;
}

std::string tilt_warning(const SliceStack& stack, const glm::dmat3& axes) {
  const glm::dvec3 climb = stack.first_pixel_mm.back() - stack.first_pixel_mm.front();
  const double rise = glm::dot(climb, axes[2]);
  const double degrees =
      std::acos(std::clamp(rise / glm::length(climb), -1.0, 1.0)) * 180 / std::numbers::pi;
  return fmt::format(
      "slices are sheared by {:.1f} degrees (gantry tilt); resampled to a right grid", degrees);
}

/// Sets the slices' places along i and j and widens the grid to hold them all.
bool place_in_plane(const SliceStack& stack, const glm::dmat3& axes, GridPlan& plan) {
  plan.geometry.size_voxels.x = stack.size_px.x;
  plan.geometry.size_voxels.y = stack.size_px.y;
  const std::vector<glm::dvec2> shifts = shifts_px(stack, axes);
  glm::dvec2 low(0.0);
  glm::dvec2 high(0.0);
  for (const auto& shift : shifts) {
    low = glm::min(low, shift);
    high = glm::max(high, shift);
  }
  const glm::dvec2 spread = high - low;
  if (std::max(spread.x, spread.y) <= kShiftTolerancePx) return false;
  const glm::dvec2 first = glm::floor(low);
  const glm::dvec2 added = glm::min(glm::ceil(high) - first, glm::dvec2(1e6));
  plan.geometry.size_voxels.x += static_cast<int>(added.x);
  plan.geometry.size_voxels.y += static_cast<int>(added.y);
  plan.geometry.origin_patient_mm += axes[0] * (first.x * stack.pixel_spacing_mm.x) +
                                     axes[1] * (first.y * stack.pixel_spacing_mm.y);
  for (std::size_t k = 0; k < shifts.size(); ++k) plan.placements[k].shift_px = shifts[k] - first;
  plan.warnings.push_back(tilt_warning(stack, axes));
  return true;
}

}  // namespace

GridPlan plan_grid(const std::filesystem::path& file, const SliceStack& stack,
                   std::uint64_t bytes_per_voxel, const ImportLimits& limits) {
  const int slices = static_cast<int>(stack.first_pixel_mm.size());
  require_volume_extents(file, {stack.size_px, slices});
  require_spacing(file, stack.pixel_spacing_mm);
  require_axes(file, stack);
  for (const auto& corner : stack.first_pixel_mm) require_reach(file, corner);
  const glm::dmat3 axes = right_axes(stack);
  GridPlan plan;
  plan.placements.resize(static_cast<std::size_t>(slices));
  plan.geometry.direction_patient = axes;
  plan.geometry.origin_patient_mm = stack.first_pixel_mm.front();
  plan.geometry.spacing_mm = {stack.pixel_spacing_mm, 1.0};
  const bool uneven = place_along_k(file, heights_mm(stack, axes), plan);
  const bool tilted = place_in_plane(stack, axes, plan);
  plan.needs_resampling = uneven || tilted;
  const glm::ivec3 size = plan.geometry.size_voxels;
  checked_voxel_count(file, std::array<std::int64_t, 3>{size.x, size.y, size.z}, bytes_per_voxel,
                      limits);
  const BoundingBox bounds = bounds_patient_mm(plan.geometry);
  require_reach(file, bounds.minimum_mm);
  require_reach(file, bounds.maximum_mm);
  return plan;
}

SliceStack stack_of_affine(glm::ivec3 size_voxels, const glm::dmat3& steps_mm,
                           glm::dvec3 origin_mm) {
  SliceStack stack;
  stack.size_px = size_voxels;
  stack.pixel_spacing_mm = {glm::length(steps_mm[0]), glm::length(steps_mm[1])};
  stack.i_axis = steps_mm[0] / stack.pixel_spacing_mm.x;
  stack.j_axis = steps_mm[1] / stack.pixel_spacing_mm.y;
  for (int k = 0; k < size_voxels.z; ++k) {
    stack.first_pixel_mm.push_back(origin_mm + steps_mm[2] * static_cast<double>(k));
  }
  return stack;
}

}  // namespace cutaway::reading
