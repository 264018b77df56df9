#include "import/pictures/tiff_pages.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <span>
#include <vector>

namespace cutaway::reading {

namespace {

/// The values of some fields; 0 for one that is not there.
template <std::size_t N>
using Fields = std::array<std::uint64_t, N>;

/// What tells pages apart.
constexpr Fields<5> kShapeTags{256,   // width
                               257,   // height
                               258,   // bits a sample
                               277,   // samples a pixel
                               339};  // sample format

class Directories {
 public:
  explicit Directories(const std::filesystem::path& file) : input_(file, std::ios::binary) {
    std::array<char, 2> order{};
    input_.read(order.data(), order.size());
    big_endian_ = order[0] == 'M';
    const bool known = order == std::array{'I', 'I'} || order == std::array{'M', 'M'};
    const std::uint64_t version = number(2);
    big_tiff_ = version == 43;
    if (!input_ || !known || (version != 42 && !big_tiff_)) return;
    if (big_tiff_) input_.seekg(8);  // behind the size of its offsets
    next_ = number(offset_bytes());
  }

  bool is_big_endian() const { return big_endian_; }

  /// Of the next page. Nothing at the end of the chain, or where it leads to no directory.
  template <std::size_t N>
  std::optional<Fields<N>> next(const Fields<N>& tags) {
    constexpr std::uint64_t kMostFields = 65535;
    if (next_ == 0 || next_ > kFurthest) return std::nullopt;
    input_.seekg(static_cast<std::streamoff>(next_));
    const std::uint64_t fields = number(big_tiff_ ? 8 : 2);
    if (!input_ || fields == 0 || fields > kMostFields) return std::nullopt;
    std::vector<unsigned char> bytes(fields * field_bytes());
    input_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    next_ = number(offset_bytes());
    if (!input_) return std::nullopt;
    return values_of(tags, bytes);
  }

 private:
  static constexpr std::uint64_t kFurthest = std::uint64_t{1} << 62;

  std::size_t offset_bytes() const { return big_tiff_ ? 8 : 4; }
  std::size_t field_bytes() const { return big_tiff_ ? 20 : 12; }

  std::uint64_t number_in(std::span<const unsigned char> bytes) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value = value << 8 | bytes[big_endian_ ? i : bytes.size() - 1 - i];
    return value;
  }

  std::uint64_t number(std::size_t size) {
    std::array<unsigned char, 8> bytes{};
    input_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    return number_in(std::span(bytes).first(size));
  }

  template <std::size_t N>
  Fields<N> values_of(const Fields<N>& tags, std::span<const unsigned char> bytes) const {
    Fields<N> values{};
    for (; !bytes.empty(); bytes = bytes.subspan(field_bytes())) {
      const auto tag = std::find(tags.begin(), tags.end(), number_in(bytes.first(2)));
      if (tag == tags.end()) continue;
      values.at(static_cast<std::size_t>(tag - tags.begin())) =
          value_in(bytes.first(field_bytes()));
    }
    return values;
  }

  /// A number; for several their count, since they may lie elsewhere.
  std::uint64_t value_in(std::span<const unsigned char> field) const {
    constexpr std::uint64_t kShort = 3;
    constexpr std::uint64_t kLong8 = 16;
    const std::uint64_t count = number_in(field.subspan(4, offset_bytes()));
    if (count != 1) return count;
    const auto value = field.last(offset_bytes());
    const std::uint64_t type = number_in(field.subspan(2, 2));
    return number_in(value.first(type == kShort ? 2 : type == kLong8 ? 8 : 4));
  }

  std::ifstream input_;
  bool big_endian_ = false;
  bool big_tiff_ = false;
  std::uint64_t next_ = 0;
};

}  // namespace

TiffPages tiff_pages(const std::filesystem::path& file, int most) {
  Directories directories(file);
  TiffPages pages;
  std::optional<Fields<5>> first;
  while (pages.count <= most) {
    const auto shape = directories.next(kShapeTags);
    if (!shape) break;
    if (!first) first = shape;
    if (*shape != *first && !pages.first_that_differs) pages.first_that_differs = pages.count;
    ++pages.count;
  }
  return pages;
}

std::optional<PlainPixels> plain_pixels(const std::filesystem::path& file) {
  constexpr Fields<4> kTags{257,   // height
                            259,   // compression
                            273,   // strip offset; several give their count, which is too small
                            278};  // rows a strip
  constexpr std::uint64_t kNoCompression = 1;
  Directories directories(file);
  const auto values = directories.next(kTags);
  if (!values) return std::nullopt;
  const auto& [height, compression, begin, rows] = *values;
  const bool one_piece = rows == 0 || rows >= height;
  if (compression > kNoCompression || !one_piece || begin < 8) return std::nullopt;
  return PlainPixels{begin, directories.is_big_endian()};
}

}  // namespace cutaway::reading
