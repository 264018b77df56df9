#include "import/dicom/padding.h"

#include <algorithm>

#include "import/dicom/data_set.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// Writers give the 16 bits as US or SS whatever the pixels are; the pixels' sign counts.
std::optional<double> stored_integer(const DataSet& data, DicomTag tag) {
  const auto number = data.binary(tag);
  if (!number) return std::nullopt;
  const bool pixels_are_signed = data.binary(0x00280103).value_or(0) == 1;
  if (pixels_are_signed && *number > 32767 && *number <= 65535) return *number - 65536;
  if (!pixels_are_signed && *number < 0) return *number + 65536;
  return number;
}

std::optional<PixelPadding> between(std::optional<double> value, std::optional<double> limit) {
  if (!value) return std::nullopt;
  return PixelPadding{std::min(*value, limit.value_or(*value)),
                      std::max(*value, limit.value_or(*value))};
}

template <typename T>
std::size_t replace(const std::filesystem::path& file, const PaddingMask& padding, bool inverted,
                    std::vector<T>& values) {
  std::optional<T> smallest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (padding.holds(i)) continue;
    const bool is_smaller = !smallest || (inverted ? values[i] > *smallest : values[i] < *smallest);
    if (is_smaller) smallest = values[i];
  }
  if (!smallest) {
    refuse(file, "every pixel of the volume is padding",
           "values other than PixelPaddingValue (0028,0120)");
  }
  std::size_t replaced = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!padding.holds(i)) continue;
    values[i] = *smallest;
    ++replaced;
  }
  return replaced;
}

}  // namespace

std::optional<PixelPadding> pixel_padding(const DataSet& data, Component component) {
  if (component == Component::float32)
    return between(data.binary(0x00280122), data.binary(0x00280124));
  if (component == Component::float64)
    return between(data.binary(0x00280123), data.binary(0x00280125));
  return between(stored_integer(data, 0x00280120), stored_integer(data, 0x00280121));
}

std::size_t replace_padding(const std::filesystem::path& file, const PaddingMask& padding,
                            double slope, RawVoxels& voxels) {
  if (padding.empty()) return 0;
  return std::visit([&](auto& values) { return replace(file, padding, slope < 0, values); },
                    voxels);
}

}  // namespace cutaway::reading
