#include "volume/voxel_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/error.h"

namespace cutaway {

namespace {

void require_rescale(double slope, double intercept) {
  if (std::isfinite(slope) && std::isfinite(intercept) && slope != 0.0) return;
  throw Error({.code = "volume-refused",
               .message = "the rescale of the values is unusable",
               .expected = "a finite slope other than 0 and a finite intercept",
               .received = std::to_string(slope) + " and " + std::to_string(intercept)});
}

[[noreturn]] void refuse_without_values(std::size_t count) {
  throw Error({.code = "volume-refused",
               .message = "no voxel has a value",
               .expected = "at least one finite value",
               .received = std::to_string(count) + " voxels, none of them finite"});
}

/// A double may be finite and yet too large for the float that stores it.
template <typename T>
std::optional<float> to_finite_float(T value, double slope, double intercept) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  const double physical = double(value) * slope + intercept;
  return std::abs(physical) <= kLargest ? std::optional(float(physical)) : std::nullopt;
}

/// What stored floats are multiples of: shaders square their differences, and far from 1 the
/// squares overflow or vanish. A power of two costs no digit.
double float_scale(double largest_magnitude) {
  constexpr double kSmallestHarmless = 1e-3;
  constexpr double kLargestHarmless = 1e12;
  const bool harmless =
      largest_magnitude >= kSmallestHarmless && largest_magnitude <= kLargestHarmless;
  if (harmless || largest_magnitude == 0.0) return 1.0;
  return std::exp2(std::ilogb(largest_magnitude));
}

void divide(std::vector<float>& stored, double scale) {
  if (scale == 1.0) return;
  for (float& value : stored) value = float(value / scale);
}

template <typename T>
PackedVoxels pack_float(std::span<const T> values, double slope, double intercept) {
  PackedVoxels packed;
  std::vector<float> stored(values.size());
  float smallest = std::numeric_limits<float>::max();
  float largest = std::numeric_limits<float>::lowest();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<float> value = to_finite_float(values[i], slope, intercept);
    stored[i] = value.value_or(std::numeric_limits<float>::quiet_NaN());
    packed.replaced_non_finite += value ? 0 : 1;
    smallest = std::min(smallest, value.value_or(smallest));
    largest = std::max(largest, value.value_or(largest));
  }
  if (packed.replaced_non_finite == values.size()) refuse_without_values(values.size());
  if (packed.replaced_non_finite > 0) {
    std::replace_if(
        stored.begin(), stored.end(), [](float v) { return std::isnan(v); }, smallest);
  }
  packed.value_range = {smallest, largest};
  packed.value_scale = float_scale(std::max(std::abs(smallest), std::abs(largest)));
  divide(stored, packed.value_scale);
  packed.voxels = std::move(stored);
  return packed;
}

/// std::minmax_element looks at places, one by one; values alone are compared many at a time.
template <typename T>
std::pair<T, T> ends_of(std::span<const T> values) {
  T smallest = values.front();
  T largest = values.front();
  for (const T value : values) {
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
  }
  return {smallest, largest};
}

/// Unsigned subtraction gives the distance of any two values of T, signed or not, without overflow.
template <typename T>
std::uint32_t distance_from(T smallest, T value) {
  return std::uint32_t(value) - std::uint32_t(smallest);
}

/// Counted from the end that is physically smallest, so that stored values rise with those that
/// they mean.
template <typename T>
PackedVoxels pack_uint16(std::span<const T> values, T smallest, T largest, double slope,
                         double intercept) {
  const bool falls = slope < 0.0;
  std::vector<std::uint16_t> stored(values.size());
  std::transform(values.begin(), values.end(), stored.begin(), [=](T value) {
    return std::uint16_t(falls ? distance_from(value, largest) : distance_from(smallest, value));
  });
  const double scale = std::abs(slope);
  const double offset = double(falls ? largest : smallest) * slope + intercept;
  const double last = double(distance_from(smallest, largest)) * scale + offset;
  return {.voxels = std::move(stored),
          .value_scale = scale,
          .value_offset = offset,
          .value_range = {offset, last}};
}

}  // namespace

template <typename T>
PackedVoxels pack_voxels(std::span<const T> values, double slope, double intercept) {
  require_rescale(slope, intercept);
  if (values.empty()) refuse_without_values(0);
  if constexpr (std::is_integral_v<T>) {
    const auto [smallest, largest] = ends_of(values);
    const bool all_finite =
        to_finite_float(smallest, slope, intercept) && to_finite_float(largest, slope, intercept);
    if (all_finite &&
        distance_from(smallest, largest) <= std::numeric_limits<std::uint16_t>::max()) {
      return pack_uint16(values, smallest, largest, slope, intercept);
    }
  }
  return pack_float(values, slope, intercept);
}

template PackedVoxels pack_voxels(std::span<const std::int8_t>, double, double);
template PackedVoxels pack_voxels(std::span<const std::uint8_t>, double, double);
template PackedVoxels pack_voxels(std::span<const std::int16_t>, double, double);
template PackedVoxels pack_voxels(std::span<const std::uint16_t>, double, double);
template PackedVoxels pack_voxels(std::span<const std::int32_t>, double, double);
template PackedVoxels pack_voxels(std::span<const std::uint32_t>, double, double);
template PackedVoxels pack_voxels(std::span<const float>, double, double);
template PackedVoxels pack_voxels(std::span<const double>, double, double);

}  // namespace cutaway
