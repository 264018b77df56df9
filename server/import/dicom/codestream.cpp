#include "import/dicom/codestream.h"

#include <algorithm>

#include "import/dicom/element_head.h"

namespace cutaway::reading {

namespace {

constexpr std::string_view kJpegStart = "\xFF\xD8";
constexpr std::string_view kJpeg2000Start = "\xFF\x4F\xFF\x51";
constexpr std::string_view kJpeg2000File("\0\0\0\x0C\x6A\x50", 6);

std::uint32_t number(std::string_view bytes, std::size_t first, std::size_t count) {
  return number_of_bytes(bytes.substr(first, count), true);
}

/// SOF0 to SOF15 but for tables, arithmetic conditioning and the extension; SOF55 of JPEG-LS.
bool begins_frame(unsigned char marker) {
  const bool is_frame =
      marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
  return is_frame || marker == 0xF7;
}

std::optional<Codestream> of_jpeg(std::string_view bytes) {
  std::size_t at = bytes.find(kJpegStart);
  if (at == bytes.npos) return std::nullopt;
  at += kJpegStart.size();
  while (at + 10 <= bytes.size() && bytes[at] == '\xFF') {
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    if (marker == 0xFF) {
      ++at;
      continue;
    }
    if (begins_frame(marker)) {
      return Codestream{number(bytes, at + 7, 2), number(bytes, at + 5, 2),
                        static_cast<int>(number(bytes, at + 4, 1)),
                        static_cast<int>(number(bytes, at + 9, 1))};
    }
    at += 2 + number(bytes, at + 2, 2);
  }
  return std::nullopt;
}

std::optional<Codestream> of_jpeg_2000(std::string_view bytes) {
  const std::size_t at = bytes.find(kJpeg2000Start);
  if (at == bytes.npos || bytes.size() - at < 43) return std::nullopt;
  // Behind SOC and the SIZ marker: length, capabilities, then the extents of image and its offset.
  const std::string_view size = bytes.substr(at + 4);
  const std::uint32_t right = number(size, 4, 4);
  const std::uint32_t bottom = number(size, 8, 4);
  const std::uint32_t left = number(size, 12, 4);
  const std::uint32_t top = number(size, 16, 4);
  if (left >= right || top >= bottom) return std::nullopt;
  return Codestream{right - left, bottom - top, static_cast<int>(number(size, 38, 1) & 0x7F) + 1,
                    static_cast<int>(number(size, 36, 2))};
}

}  // namespace

std::optional<Codestream> codestream_of(std::string_view bytes, PixelPacking packing) {
  if (packing == PixelPacking::jpeg_2000) return of_jpeg_2000(bytes);
  return of_jpeg(bytes);
}

bool begins_picture(std::string_view bytes, PixelPacking packing) {
  if (packing == PixelPacking::rle) return true;
  if (packing == PixelPacking::jpeg_2000)
    return bytes.starts_with(kJpeg2000Start) || bytes.starts_with(kJpeg2000File);
  return bytes.starts_with(kJpegStart);
}

}  // namespace cutaway::reading
