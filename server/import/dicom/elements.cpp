#include "import/dicom/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "import/dicom/frame.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kFirstElement = 132;  // behind the preamble and "DICM"
constexpr std::uint64_t kTagBytes = 4;
constexpr std::uint64_t kShortHead = 8;  // tag, VR, 16 bits of length; or tag, 32 bits of length
constexpr std::uint64_t kLongHead = 12;  // tag, VR, two bytes of nothing, 32 bits of length
constexpr std::uint32_t kUndefinedLength = 0xFFFFFFFF;
constexpr std::uint32_t kTransferSyntax = 0x00020010;
constexpr std::uint32_t kPixelData = 0x7FE00010;
constexpr std::uint32_t kItem = 0xFFFEE000;
constexpr std::uint32_t kItemEnd = 0xFFFEE00D;
constexpr std::uint32_t kSequenceEnd = 0xFFFEE0DD;

constexpr std::string_view kLongHeadVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
constexpr std::string_view kShortHeadVrs =
    "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";

/// How the elements of a part of the file are written.
struct Encoding {
  bool has_vr = true;
  bool is_big_endian = false;
};

struct Element {
  std::uint32_t tag = 0;
  bool is_understood = false;
  bool is_sequence = false;
  std::uint64_t head_bytes = kShortHead;
  std::uint32_t length = 0;

  bool is_open() const { return length == kUndefinedLength; }
};

/// A file read in pieces, for elements lie close to each other but for a few.
class Pieces {
 public:
  explicit Pieces(const fs::path& file)
      : input_(file, std::ios::binary), size_(fs::file_size(file)), piece_(kPieceBytes) {}

  std::uint64_t size() const { return size_; }

  /// Zeros behind the end.
  std::string_view at(std::uint64_t offset, std::uint64_t bytes) {
    if (offset < begin_ || offset + bytes > begin_ + kPieceBytes || !is_filled_) fill(offset);
    return std::string_view(piece_.data(), piece_.size()).substr(offset - begin_, bytes);
  }

 private:
  static constexpr std::uint64_t kPieceBytes = 16384;

  void fill(std::uint64_t offset) {
    std::fill(piece_.begin(), piece_.end(), '\0');
    input_.clear();
    input_.seekg(static_cast<std::streamoff>(offset));
    input_.read(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    begin_ = offset;
    is_filled_ = true;
  }

  std::ifstream input_;
  std::uint64_t size_;
  std::vector<char> piece_;
  std::uint64_t begin_ = 0;
  bool is_filled_ = false;
};

std::uint32_t number_of(std::string_view bytes, bool is_big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t next = is_big_endian ? i : bytes.size() - 1 - i;
    number = number << 8 | static_cast<unsigned char>(bytes[next]);
  }
  return number;
}

bool is_one_of(std::string_view vrs, std::string_view vr) {
  const std::size_t place = vrs.find(vr);
  return place != std::string_view::npos && place % 3 == 0 &&
         vr.find(' ') == std::string_view::npos;
}

Element element_in(std::string_view head, const Encoding& encoding) {
  const auto number = [&](std::size_t first, std::size_t bytes) {
    return number_of(head.substr(first, bytes), encoding.is_big_endian);
  };
  Element element{.tag = number(0, 2) << 16 | number(2, 2)};
  const std::string_view vr = head.substr(4, 2);
  const bool is_long = is_one_of(kLongHeadVrs, vr);
  const bool is_known_vr = is_long || is_one_of(kShortHeadVrs, vr);
  const bool is_delimiter =
      element.tag == kItem || element.tag == kItemEnd || element.tag == kSequenceEnd;
  if (is_delimiter || !encoding.has_vr) {
    element.is_understood = is_delimiter || !is_known_vr;
    element.length = number(4, 4);
    element.is_sequence = element.is_open();
    return element;
  }
  element.is_understood = is_known_vr;
  element.head_bytes = is_long ? kLongHead : kShortHead;
  element.length = is_long ? number(8, 4) : number(6, 2);
  element.is_sequence = vr == "SQ" || element.tag == kPixelData;
  return element;
}

class Walk {
 public:
  explicit Walk(const fs::path& file) : file_(file), pieces_(file) {}

  void run() {
    if (!pass_file_header() || syntax_ == "1.2.840.10008.1.2.1.99") return;
    encoding_.has_vr = syntax_ != "1.2.840.10008.1.2";
    encoding_.is_big_endian = syntax_ == "1.2.840.10008.1.2.2";
    pass_data_set();
  }

 private:
  /// Group 0002; false where it is not understood. A file may not end behind it either.
  bool pass_file_header() {
    while (true) {
      require_bytes(kShortHead);
      const Element element = next();
      if (element.tag >> 16 != 2) return true;
      if (!element.is_understood || element.is_open()) return false;
      require_bytes(element.head_bytes + element.length);
      if (element.tag == kTransferSyntax) syntax_ = text_of(element);
      offset_ += element.head_bytes + element.length;
    }
  }

  /// Steps over what has a length and into what has none, so that the depth is all there is to
  /// remember of sequences.
  void pass_data_set() {
    std::uint32_t last_tag = 0;
    for (int depth = 0; pieces_.size() - offset_ >= kTagBytes;) {
      const Element element = next();
      if (depth == 0 && (element.tag == kPixelData || element.tag <= last_tag)) return;
      require_bytes(kShortHead);
      if (!element.is_understood || depth < 0) return;
      require_bytes(element.head_bytes);
      if (depth == 0) last_tag = element.tag;
      offset_ += element.head_bytes;
      if (element.tag == kItemEnd || element.tag == kSequenceEnd) --depth;
      if (element.is_open() && !element.is_sequence && element.tag != kItem) return;
      if (element.is_open()) ++depth;
      if (!element.is_open()) require_bytes(element.length);
      if (!element.is_open()) offset_ += element.length;
    }
  }

  Element next() { return element_in(pieces_.at(offset_, kLongHead), encoding_); }

  std::string text_of(const Element& element) {
    constexpr std::uint32_t kLongestUid = 64;
    std::string text(
        pieces_.at(offset_ + element.head_bytes, std::min(element.length, kLongestUid)));
    while (!text.empty() && (text.back() == '\0' || text.back() == ' ')) text.pop_back();
    return text;
  }

  void require_bytes(std::uint64_t bytes) const {
    if (offset_ + bytes <= pieces_.size()) return;
    refuse(file_, "the DICOM header is cut off", fmt::format("at least {} bytes", offset_ + bytes),
           fmt::format("{} bytes", pieces_.size()));
  }

  const fs::path& file_;
  Pieces pieces_;
  Encoding encoding_;
  std::string syntax_;
  std::uint64_t offset_ = kFirstElement;
};

}  // namespace

void require_whole_elements(const fs::path& file) {
  if (has_dicom_magic(file)) Walk(file).run();
}

}  // namespace cutaway::reading
