#include "import/dicom/placement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "import/data_root.h"
#include "import/refusal.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

std::vector<double> required(const DicomFrame& frame, const std::string& whose,
                             const std::vector<DataSet>& groups, DicomTag tag, std::size_t count,
                             const char* name) {
  std::vector<double> numbers;
  for (const auto& group : groups) {
    numbers = group.decimals(tag);
    if (are_finite(numbers, count)) return numbers;
    if (!numbers.empty()) break;
  }
  refuse(frame.image->file, fmt::format("{} has no usable {}", whose, name),
         fmt::format("{} finite numbers", count), fmt::format("{}", fmt::join(numbers, ", ")));
}

constexpr std::string_view kPlainDecimals("0123456789.+-\\ \0", 16);

/// Half of the last digit that any of the numbers has; 0 where they are written in another way.
double half_digit(const std::vector<DataSet>& groups, DicomTag tag) {
  for (const auto& group : groups) {
    const std::string text = group.raw(tag);
    if (text.empty()) continue;
    if (text.find_first_not_of(kPlainDecimals) != std::string::npos) return 0.0;
    std::size_t decimals = 0;
    for (std::size_t dot = text.find('.'); dot != text.npos; dot = text.find('.', dot + 1)) {
      const std::size_t end = text.find_first_not_of("0123456789", dot + 1);
      decimals = std::max(decimals, std::min(end, text.size()) - dot - 1);
    }
    return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
  }
  return 0.0;
}

/// Cosines that make right angles to the last digit were not rounded; others that pass for a
/// direction at all have three digits or more.
double axis_error(const DicomFrame& frame, double half_digit) {
  constexpr double kExact = 1e-7;
  constexpr double kLargest = 5e-4;
  const bool is_exact = std::abs(glm::length(frame.row_axis) - 1) < kExact &&
                        std::abs(glm::length(frame.column_axis) - 1) < kExact &&
                        std::abs(glm::dot(frame.row_axis, frame.column_axis)) < kExact;
  return is_exact ? 0.0 : std::min(half_digit, kLargest);
}

/// Days since some day of old, each month of 31: all that an order wants.
double days_in(std::string_view date) {
  const auto number = [&](std::size_t first, std::size_t digits) {
    return real_of(date.substr(first, digits)).value_or(0.0);
  };
  return (number(0, 4) * 12 + number(4, 2)) * 31 + number(6, 2);
}

}  // namespace

void place(DicomFrame& frame, const std::string& whose, const std::vector<DataSet>& groups) {
  const auto position = required(frame, whose, groups, 0x00200032, 3, "ImagePositionPatient");
  const auto axes = required(frame, whose, groups, 0x00200037, 6, "ImageOrientationPatient");
  const auto spacing = required(frame, whose, groups, 0x00280030, 2, "PixelSpacing");
  frame.position_mm = {position[0], position[1], position[2]};
  frame.row_axis = {axes[0], axes[1], axes[2]};
  frame.column_axis = {axes[3], axes[4], axes[5]};
  frame.spacing_mm = {spacing[1], spacing[0]};  // the file gives rows' distance first
  frame.position_error_mm = half_digit(groups, 0x00200032);
  frame.axis_error = axis_error(frame, half_digit(groups, 0x00200037));
  for (const auto& group : groups) {
    const double thickness = group.decimal(0x00180050).value_or(0.0);
    if (std::isfinite(thickness) && thickness > 0) {
      frame.thickness_mm = thickness;
      break;
    }
  }
}

std::optional<double> moment_of(std::string_view text) {
  text = trimmed(text);
  const std::size_t zone = text.find_first_of("+-&");
  text = text.substr(0, zone);
  std::size_t digits = std::min(text.find('.'), text.size());
  double days = 0.0;
  if (digits > 8) {
    days = days_in(text.substr(0, 8));
    text = trimmed(text.substr(8));
    digits = std::min(text.find('.'), text.size());
  }
  if (digits < 6 || !real_of(text)) return std::nullopt;
  const double hours = real_of(text.substr(0, 2)).value_or(0.0);
  const double minutes = real_of(text.substr(2, 2)).value_or(0.0);
  const double seconds = real_of(text.substr(4)).value_or(0.0);
  return ((days * 24 + hours) * 60 + minutes) * 60 + seconds;
}

}  // namespace cutaway::reading
