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
  throw Error({.code = ErrorCode::volume_refused,
               .message = "the rescale of the values is unusable",
               .expected = "a finite slope other than 0 and a finite intercept",
               .received = std::to_string(slope) + " and " + std::to_string(intercept)});
}

[[noreturn]] void refuse_without_values(std::size_t count) {
  throw Error({.code = ErrorCode::volume_refused,
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

/// Below all values, and a different float than any of them.
float below(float smallest, float largest, bool all_whole) {
  constexpr double kShareOfRange = 1.0 / 256.0;
  const double range = double(largest) - smallest;
  double gap = all_whole     ? 1.0
               : range > 0.0 ? kShareOfRange * range
                             : std::max(std::abs(double(smallest)), 1.0);
  while (!(float(smallest - gap) < smallest)) gap *= 2.0;
  return float(std::max(smallest - gap, double(std::numeric_limits<float>::lowest())));
}

using Consumed = std::function<void(std::size_t values)>;

/// Piece by piece, so that the new values take memory only as the old ones give it back.
template <typename To, typename T, typename Convert>
std::vector<To> converted(std::span<const T> values, const Convert& convert,
                          const Consumed& consumed) {
  constexpr std::size_t kPiece = std::size_t{1} << 22;
  std::vector<To> result;
  result.reserve(values.size());
  while (result.size() < values.size()) {
    const std::size_t done = result.size();
    const auto piece = values.subspan(done, std::min(kPiece, values.size() - done));
    result.resize(done + piece.size());
    std::transform(piece.begin(), piece.end(), result.begin() + std::ptrdiff_t(done), convert);
    if (consumed) consumed(result.size());
  }
  return result;
}

/// NaN for what has no value.
template <typename T>
std::vector<float> physical_values(std::span<const T> values, double slope, double intercept,
                                   const ValidValues<T>& valid, const Consumed& consumed) {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  const auto physical = [&](T value) {
    if (!valid.holds(value)) return kNothing;
    return to_finite_float(value, slope, intercept).value_or(kNothing);
  };
  return converted<float>(values, physical, consumed);
}

template <typename T>
PackedVoxels pack_float(std::span<const T> values, double slope, double intercept,
                        const ValidValues<T>& valid, const Consumed& consumed) {
  PackedVoxels packed;
  std::vector<float> stored = physical_values(values, slope, intercept, valid, consumed);
  float smallest = std::numeric_limits<float>::max();
  float largest = std::numeric_limits<float>::lowest();
  bool all_whole = true;
  for (const float value : stored) {
    packed.nothing_voxels += std::isnan(value) ? 1 : 0;
    smallest = value < smallest ? value : smallest;
    largest = value > largest ? value : largest;
    all_whole = all_whole && (std::isnan(value) || value == std::trunc(value));
  }
  if (packed.nothing_voxels == values.size()) refuse_without_values(values.size());
  if (packed.nothing_voxels > 0) {
    const float nothing = below(smallest, largest, all_whole);
    packed.nothing_value = nothing;
    std::replace_if(
        stored.begin(), stored.end(), [](float v) { return std::isnan(v); }, nothing);
  }
  packed.value_range = {smallest, largest};
  packed.value_scale = float_scale(std::max(std::abs(smallest), std::abs(largest)));
  divide(stored, packed.value_scale);
  packed.voxels = std::move(stored);
  return packed;
}

template <typename T>
struct Ends {
  T smallest = std::numeric_limits<T>::max();
  T largest = std::numeric_limits<T>::lowest();
  std::size_t nothing_voxels = 0;
};

/// std::minmax_element looks at places, one by one; values alone are compared many at a time.
template <typename T>
Ends<T> ends_of(std::span<const T> values, const ValidValues<T>& valid) {
  Ends<T> ends;
  for (const T value : values) {
    const bool holds = valid.holds(value);
    ends.smallest = std::min(ends.smallest, holds ? value : ends.smallest);
    ends.largest = std::max(ends.largest, holds ? value : ends.largest);
    ends.nothing_voxels += holds ? 0 : 1;
  }
  if (ends.nothing_voxels == values.size()) refuse_without_values(values.size());
  return ends;
}

/// Unsigned subtraction gives the distance of any two values of T, signed or not, without overflow.
template <typename T>
std::uint32_t distance_from(T smallest, T value) {
  return std::uint32_t(value) - std::uint32_t(smallest);
}

template <typename T>
bool fits_uint16(const Ends<T>& ends, double slope, double intercept) {
  const std::uint32_t most =
      std::numeric_limits<std::uint16_t>::max() - (ends.nothing_voxels > 0 ? 1U : 0U);
  return to_finite_float(ends.smallest, slope, intercept) &&
         to_finite_float(ends.largest, slope, intercept) &&
         distance_from(ends.smallest, ends.largest) <= most;
}

/// Counted from the end that is physically smallest, so that stored values rise with those that
/// they mean. Where some have none, 0 is theirs and the others begin at 1.
template <typename T>
PackedVoxels pack_uint16(std::span<const T> values, const Ends<T>& ends, double slope,
                         double intercept, const ValidValues<T>& valid, const Consumed& consumed) {
  const bool falls = slope < 0.0;
  const std::uint32_t first = ends.nothing_voxels > 0 ? 1 : 0;
  const auto to_stored = [&](T value) {
    if (!valid.holds(value)) return std::uint16_t{0};
    return std::uint16_t(
        first + (falls ? distance_from(value, ends.largest) : distance_from(ends.smallest, value)));
  };
  const double scale = std::abs(slope);
  const double lowest = double(falls ? ends.largest : ends.smallest) * slope + intercept;
  const double highest = double(distance_from(ends.smallest, ends.largest)) * scale + lowest;
  PackedVoxels packed{.voxels = converted<std::uint16_t>(values, to_stored, consumed),
                      .value_scale = scale,
                      .value_offset = lowest - first * scale,
                      .value_range = {lowest, highest},
                      .nothing_voxels = ends.nothing_voxels};
  if (first > 0) packed.nothing_value = packed.value_offset;
  return packed;
}

}  // namespace

template <typename T>
PackedVoxels pack_voxels(std::span<const T> values, double slope, double intercept,
                         const ValidValues<T>& valid, const Consumed& consumed) {
  require_rescale(slope, intercept);
  if (values.empty()) refuse_without_values(0);
  if constexpr (std::is_integral_v<T>) {
    const Ends<T> ends = ends_of(values, valid);
    if (fits_uint16(ends, slope, intercept))
      return pack_uint16(values, ends, slope, intercept, valid, consumed);
  }
  return pack_float(values, slope, intercept, valid, consumed);
}

template PackedVoxels pack_voxels(std::span<const std::int8_t>, double, double,
                                  const ValidValues<std::int8_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const std::uint8_t>, double, double,
                                  const ValidValues<std::uint8_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const std::int16_t>, double, double,
                                  const ValidValues<std::int16_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const std::uint16_t>, double, double,
                                  const ValidValues<std::uint16_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const std::int32_t>, double, double,
                                  const ValidValues<std::int32_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const std::uint32_t>, double, double,
                                  const ValidValues<std::uint32_t>&, const Consumed&);
template PackedVoxels pack_voxels(std::span<const float>, double, double, const ValidValues<float>&,
                                  const Consumed&);
template PackedVoxels pack_voxels(std::span<const double>, double, double,
                                  const ValidValues<double>&, const Consumed&);

}  // namespace cutaway
