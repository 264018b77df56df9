#include "import/dicom/padding.h"

#include <algorithm>

#include "import/dicom/dataset.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// Writers give the 16 bits as US or SS whatever the pixels are; the pixels' sign counts.
std::optional<double> stored_number(const gdcm::DataSet& data, std::uint16_t element) {
  const auto number = binary_at(data, 0x0028, element);
  if (!number) return std::nullopt;
  const bool pixels_are_signed = binary_at(data, 0x0028, 0x0103).value_or(0) == 1;
  if (pixels_are_signed && *number > 32767 && *number <= 65535) return *number - 65536;
  if (!pixels_are_signed && *number < 0) return *number + 65536;
  return number;
}

template <typename T>
std::size_t replace(const std::filesystem::path& file, const PaddingMask& padding, bool inverted,
                    std::vector<T>& values) {
  std::optional<T> smallest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (padding[i]) continue;
    const bool is_smaller = !smallest || (inverted ? values[i] > *smallest : values[i] < *smallest);
    if (is_smaller) smallest = values[i];
  }
  if (!smallest) {
    refuse(file, "every pixel of the volume is padding",
           "values other than PixelPaddingValue (0028,0120)");
  }
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!padding[i]) continue;
    values[i] = *smallest;
    ++replaced;
  }
  return replaced;
}

}  // namespace

std::optional<PixelPadding> pixel_padding(const gdcm::DataSet& data) {
  const auto value = stored_number(data, 0x0120);
  if (!value) return std::nullopt;
  const double limit = stored_number(data, 0x0121).value_or(*value);
  return PixelPadding{std::min(*value, limit), std::max(*value, limit)};
}

std::size_t replace_padding(const std::filesystem::path& file, const PaddingMask& padding,
                            double slope, RawVoxels& voxels) {
  if (padding.empty()) return 0;
  return std::visit([&](auto& values) { return replace(file, padding, slope < 0, values); },
                    voxels);
}

}  // namespace cutaway::reading
