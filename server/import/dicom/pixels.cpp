#include "import/dicom/pixels.h"

#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

/// Only the stored bits count: others may hold overlays, or nothing that was meant.
template <typename T>
T stored_value(const char* bytes, const StoredBits& bits) {
  T value;
  std::memcpy(&value, bytes, sizeof(value));
  if constexpr (std::is_integral_v<T>) {
    using Unsigned = std::make_unsigned_t<T>;
    constexpr int kBits = std::numeric_limits<Unsigned>::digits;
    const auto at_top =
        static_cast<Unsigned>(static_cast<Unsigned>(value) << (kBits - 1 - bits.high_bit));
    return static_cast<T>(static_cast<T>(at_top) >> (kBits - bits.stored));
  } else {
    return value;
  }
}

template <typename From, typename To>
To converted(From value, const ValueMeaning& meaning) {
  if (meaning.table) return static_cast<To>(meaning.table->value_of(static_cast<double>(value)));
  // NOLINTNEXTLINE(bugprone-signed-char-misuse): numbers, no text
  if constexpr (std::is_integral_v<To>) return static_cast<To>(value);
  return static_cast<To>(static_cast<double>(value) * meaning.slope + meaning.intercept);
}

template <typename From, typename To>
void convert(const PlainFrame& plain, const DicomFrame& frame, std::size_t first,
             std::span<To> output, PaddingMask& padding) {
  const auto& declared = frame.image->padding;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const From value = stored_value<From>(plain.bytes.data() + i * sizeof(From), plain.bits);
    if (declared && declared->contains(static_cast<double>(value))) padding.mark(first + i);
    output[i] = converted<From, To>(value, frame.meaning);
  }
}

/// As the codec gave them, which may be narrower than the header promised.
Component component_of(const PlainFrame& plain, Component declared) {
  if (declared == Component::float32 || declared == Component::float64) return declared;
  const bool is_signed = plain.bits.is_signed;
  if (plain.bits.allocated == 8) return is_signed ? Component::int8 : Component::uint8;
  if (plain.bits.allocated == 16) return is_signed ? Component::int16 : Component::uint16;
  return is_signed ? Component::int32 : Component::uint32;
}

template <typename To>
void convert_any(const PlainFrame& plain, const DicomFrame& frame, std::size_t first,
                 std::span<To> output, PaddingMask& padding) {
  switch (component_of(plain, frame.image->component)) {
    case Component::int8:
      return convert<std::int8_t>(plain, frame, first, output, padding);
    case Component::uint8:
      return convert<std::uint8_t>(plain, frame, first, output, padding);
    case Component::int16:
      return convert<std::int16_t>(plain, frame, first, output, padding);
    case Component::uint16:
      return convert<std::uint16_t>(plain, frame, first, output, padding);
    case Component::int32:
      return convert<std::int32_t>(plain, frame, first, output, padding);
    case Component::float32:
      return convert<float>(plain, frame, first, output, padding);
    case Component::float64:
      return convert<double>(plain, frame, first, output, padding);
    default:
      return convert<std::uint32_t>(plain, frame, first, output, padding);
  }
}

}  // namespace

void store_frame(PixelFile& pixels, const DicomFrame& frame, std::size_t first, RawVoxels& voxels,
                 PaddingMask& padding) {
  const PlainFrame plain = pixels.plain(frame.index);
  const std::size_t count = std::size_t(frame.image->size_px.x) * frame.image->size_px.y;
  std::visit(
      [&](auto& values) {
        convert_any(plain, frame, first, std::span(values).subspan(first, count), padding);
      },
      voxels);
}

}  // namespace cutaway::reading
