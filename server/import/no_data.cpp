#include "import/no_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cutaway::reading {

namespace {

/// `apart` is the least distance from all other values, in their ranges. Saturated sensors also
/// give the largest number of a type, and masks may consist of it.
struct Custom {
  double number;
  double apart;
  double least_range;  ///< of the others
};

constexpr double kSaturated = 4.0;
constexpr double kNotJustLabels = 16.0;
constexpr std::array kCustoms{Custom{-2147483648.0, 1.5, 0.0},
                              Custom{-999999.0, 1.5, 0.0},
                              Custom{-99999.0, 1.5, 0.0},
                              Custom{-32768.0, 1.5, 0.0},
                              Custom{-32767.0, 1.5, 0.0},
                              Custom{-9999.0, 1.5, 0.0},
                              Custom{-999.0, 20.0, 0.0},
                              Custom{32767.0, kSaturated, kNotJustLabels},
                              Custom{65535.0, kSaturated, kNotJustLabels},
                              Custom{2147483647.0, kSaturated, kNotJustLabels},
                              Custom{4294967295.0, kSaturated, kNotJustLabels}};

/// Among floats, whatever is immense beside the rest.
constexpr double kImmense = 1e15;
constexpr double kPlain = 1e9;

template <typename T>
struct Extremes {
  T lowest = std::numeric_limits<T>::max();
  T highest = std::numeric_limits<T>::lowest();
  std::size_t count = 0;

  void take(T value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    ++count;
  }
  double range() const { return double(highest) - double(lowest); }
};

template <typename T>
Extremes<T> extremes_of(std::span<const T> values, const ValidValues<T>& valid) {
  Extremes<T> extremes;
  for (const T value : values) {
    if (valid.holds(value)) extremes.take(value);
  }
  return extremes;
}

template <typename T>
bool is_custom(T number, double apart, double range_of_others) {
  return std::ranges::any_of(kCustoms, [&](const Custom& custom) {
    return double(number) == custom.number && range_of_others > 0 &&
           range_of_others >= custom.least_range && apart >= custom.apart * range_of_others;
  });
}

template <typename T>
T just_above(T value) {
  if constexpr (std::is_integral_v<T>) {
    return T(value + 1);
  } else {
    return std::nextafter(value, std::numeric_limits<T>::max());
  }
}

template <typename T>
T just_below(T value) {
  if constexpr (std::is_integral_v<T>) {
    return T(value - 1);
  } else {
    return std::nextafter(value, std::numeric_limits<T>::lowest());
  }
}

/// Leaves out what is immense, where the rest is plain.
template <typename T>
ValidValues<T> without_immense(std::span<const T> values) {
  ValidValues<T> plain;
  if constexpr (std::is_floating_point_v<T>) {
    const ValidValues<T> candidate{T(-kImmense), T(kImmense)};
    const Extremes<T> rest = extremes_of(values, candidate);
    if (rest.count > 0 && std::max(-double(rest.lowest), double(rest.highest)) < kPlain)
      plain = candidate;
  }
  return plain;
}

/// Leaves out the lowest or the highest value, where it is a custom.
template <typename T>
void leave_out_customs(std::span<const T> values, NoData<T>& found) {
  const Extremes<T> all = extremes_of(values, found.valid);
  if (all.count == 0 || all.lowest == all.highest) return;
  const ValidValues<T> without_lowest{just_above(all.lowest), found.valid.highest};
  const Extremes<T> higher = extremes_of(values, without_lowest);
  if (is_custom(all.lowest, double(higher.lowest) - double(all.lowest), higher.range())) {
    found.valid.lowest = without_lowest.lowest;
    found.number = double(all.lowest);
  }
  const ValidValues<T> without_highest{found.valid.lowest, just_below(all.highest)};
  const Extremes<T> lower = extremes_of(values, without_highest);
  if (is_custom(all.highest, double(all.highest) - double(lower.highest), lower.range())) {
    found.valid.highest = without_highest.highest;
    found.number = double(all.highest);
  }
}

/// Of the physical values: air is -1000 HU, less noise and what calibration leaves open.
bool is_below_air(double number, double lowest_of_others, double highest_of_others) {
  constexpr double kApart = 200.0;
  const bool others_are_hounsfield = lowest_of_others >= -1200 && lowest_of_others <= -900 &&
                                     highest_of_others >= 0 && highest_of_others <= 70000;
  return others_are_hounsfield && lowest_of_others - number >= kApart;
}

/// Leaves out the physically lowest value, where it lies below air.
template <typename T>
void leave_out_below_air(std::span<const T> values, double slope, double intercept,
                         ValidValues<T>& valid) {
  const Extremes<T> all = extremes_of(values, valid);
  if (all.count == 0 || all.lowest == all.highest) return;
  const auto physical = [&](T value) { return double(value) * slope + intercept; };
  ValidValues<T> rest = valid;
  (slope < 0 ? rest.highest : rest.lowest) =
      slope < 0 ? just_below(all.highest) : just_above(all.lowest);
  const Extremes<T> others = extremes_of(values, rest);
  const double lowest = physical(slope < 0 ? others.highest : others.lowest);
  const double highest = physical(slope < 0 ? others.lowest : others.highest);
  if (is_below_air(physical(slope < 0 ? all.highest : all.lowest), lowest, highest)) valid = rest;
}

template <typename T>
bool is_finite(T value) {
  if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
  return true;
}

}  // namespace

template <typename T>
NoData<T> find_no_data(std::span<const T> values) {
  NoData<T> found{.valid = without_immense(values)};
  if constexpr (sizeof(T) > 1) leave_out_customs(values, found);
  for (const T value : values) {
    if (found.valid.holds(value) || !is_finite(value)) continue;
    ++found.voxels;
    if (!found.number) found.number = double(value);
  }
  return found;
}

template <typename T>
ValidValues<T> mixable_values(std::span<const T> values, double slope, double intercept) {
  ValidValues<T> valid = find_no_data(values).valid;
  if constexpr (sizeof(T) > 1) leave_out_below_air(values, slope, intercept, valid);
  return valid;
}

template NoData<std::int8_t> find_no_data(std::span<const std::int8_t>);
template NoData<std::uint8_t> find_no_data(std::span<const std::uint8_t>);
template NoData<std::int16_t> find_no_data(std::span<const std::int16_t>);
template NoData<std::uint16_t> find_no_data(std::span<const std::uint16_t>);
template NoData<std::int32_t> find_no_data(std::span<const std::int32_t>);
template NoData<std::uint32_t> find_no_data(std::span<const std::uint32_t>);
template NoData<float> find_no_data(std::span<const float>);
template NoData<double> find_no_data(std::span<const double>);

template ValidValues<std::int8_t> mixable_values(std::span<const std::int8_t>, double, double);
template ValidValues<std::uint8_t> mixable_values(std::span<const std::uint8_t>, double, double);
template ValidValues<std::int16_t> mixable_values(std::span<const std::int16_t>, double, double);
template ValidValues<std::uint16_t> mixable_values(std::span<const std::uint16_t>, double, double);
template ValidValues<std::int32_t> mixable_values(std::span<const std::int32_t>, double, double);
template ValidValues<std::uint32_t> mixable_values(std::span<const std::uint32_t>, double, double);
template ValidValues<float> mixable_values(std::span<const float>, double, double);
template ValidValues<double> mixable_values(std::span<const double>, double, double);

}  // namespace cutaway::reading
