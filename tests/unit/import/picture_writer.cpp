#include "unit/import/picture_writer.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "unit/import/import_test_support.h"

namespace cutaway::test {

namespace {

struct TiffField {
  std::uint16_t tag, type;  ///< types: 2 text, 3 short, 4 long, 5 rational
  std::uint32_t count, value;
};

constexpr std::uint32_t kFields = 14;
constexpr std::uint32_t kPageBytes = 2 + kFields * 12 + 4;

using TiffFields = std::array<TiffField, kFields>;

std::string padded_description(const TiffPicture& picture) {
  std::string description = picture.description;
  description.resize((description.size() / 4 + 1) * 4, '\0');
  return description;
}

TiffFields fields_of(const TiffPicture& picture, std::uint32_t page) {
  const auto text_bytes = static_cast<std::uint32_t>(padded_description(picture).size());
  const auto plane_bytes = static_cast<std::uint32_t>(picture.pixels.size()) / picture.planes;
  const std::uint32_t rationals = 8 + picture.pages * kPageBytes;
  const std::uint32_t description = rationals + 16;
  const std::uint32_t plane = std::min(page, picture.planes - 1);
  const std::uint32_t pixels = description + text_bytes + plane * plane_bytes;
  return {{{256, 4, 1, picture.size_px.x},
           {257, 4, 1, picture.size_px.y},
           {258, 3, 1, 16},
           {259, 3, 1, picture.compression},
           {262, 3, 1, 1},
           {270, 2, text_bytes, description},
           {273, 4, 1, pixels},
           {274, 3, 1, picture.orientation},
           {277, 3, 1, 1},
           {278, 4, 1, picture.size_px.y},
           {279, 4, 1, plane_bytes},
           {282, 5, 1, rationals},
           {283, 5, 1, rationals + 8},
           {296, 3, 1, picture.resolution_unit}}};
}

std::string chunk(const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const auto checksum = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  return bytes_of_numbers<std::uint32_t>({static_cast<std::uint32_t>(data.size())}, true) + body +
         bytes_of_numbers<std::uint32_t>({checksum}, true);
}

}  // namespace

std::string tiff_bytes(const TiffPicture& picture) {
  const bool big = picture.big_endian;
  const auto shorts = [&](const std::vector<std::uint16_t>& v) { return bytes_of_numbers(v, big); };
  const auto longs = [&](const std::vector<std::uint32_t>& v) { return bytes_of_numbers(v, big); };
  const auto page = [&](std::uint32_t number) {
    std::string bytes = shorts({kFields});
    for (const auto& [tag, type, count, value] : fields_of(picture, number)) {
      bytes += shorts({tag, type}) + longs({count});
      bytes += type == 3 ? shorts({static_cast<std::uint16_t>(value), 0}) : longs({value});
    }
    return bytes;
  };
  std::string file = (big ? "MM" : "II") + shorts({42}) + longs({8});
  for (std::uint32_t i = 1; i <= picture.pages; ++i)
    file += page(i - 1) + longs({i < picture.pages ? 8 + i * kPageBytes : 0});
  return file + longs({picture.resolution.x, 1, picture.resolution.y, 1}) +
         padded_description(picture) + picture.pixels;
}

std::string png_bytes(const PngPicture& picture) {
  std::string rows;
  for (std::size_t begin = 0; begin < picture.pixels.size(); begin += picture.row_bytes)
    rows += std::string(1, '\0') + picture.pixels.substr(begin, picture.row_bytes);
  const std::string header =
      bytes_of_numbers<std::uint32_t>({picture.size_px.x, picture.size_px.y}, true) +
      bytes_of_numbers<std::uint8_t>({picture.bits, picture.colour_type, 0, 0, 0});
  return "\x89PNG\r\n\x1A\n" + chunk("IHDR", header) + chunk("IDAT", zlib(rows)) +
         chunk("IEND", "");
}

}  // namespace cutaway::test
