#include "volume/voxel_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

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
  packed.voxels = std::move(stored);
  return packed;
}

/// Unsigned subtraction gives the distance of any two values of T, signed or not, without overflow.
template <typename T>
std::uint32_t distance_from(T smallest, T value) {
  return std::uint32_t(value) - std::uint32_t(smallest);
}

template <typename T>
PackedVoxels pack_uint16(std::span<const T> values, T smallest, T largest, double slope,
                         double intercept) {
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
/// Counted from the end that is physically smallest, so that stored values rise with those that
/// they mean.
  require_rescale(slope, intercept);
  if (values.empty()) refuse_without_values(0);
  if constexpr (std::is_integral_v<T>) {
  const bool falls = slope < 0.0;
    const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
    if (distance_from(*smallest, *largest) <= std::numeric_limits<std::uint16_t>::max()) {
      return pack_uint16(values, *smallest, *largest, slope, intercept);
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
