#include "import/dicom/header.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/data_root.h"
#include "import/dicom/deflated.h"
#include "import/dicom/element_head.h"
#include "import/dicom/transfer_syntax.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::uint64_t kMarkOffset = 128;
constexpr std::string_view kMark = "DICM";
constexpr int kDeepest = 128;
constexpr std::size_t kMostElements = 400'000;

bool has_mark(ByteSource& source) {
  return source.size() >= kMarkOffset + kMark.size() &&
         source.peek(kMarkOffset, kMark.size()) == kMark;
}

bool is_pixel_data(DicomTag tag) {
  return tag == 0x7FE00008 || tag == 0x7FE00009 || tag == 0x7FE00010;
}

/// Private elements and those of groups that nobody asks for would fill memory for nothing.
bool is_kept(DicomTag tag) {
  const std::uint32_t group = tag >> 16;
  return group % 2 == 0 && (group <= 0x0060 || group == 0x5200);
}

class HeaderWalk {
 public:
  HeaderWalk(ByteSource& source, std::uint64_t most_unpacked_bytes)
      : source_(source), most_unpacked_bytes_(most_unpacked_bytes) {}

  DicomHeader run() {
    require_begin();
    pass_file_header();
    if (is_unpacked_as_a_whole(header_.transfer_syntax)) unpack();
    find_encoding();
    pass_elements({.end = source_.size(), .is_top = true}, &header_.data);
    header_.is_big_endian = encoding_.is_big_endian;
    return std::move(header_);
  }

 private:
  /// A stretch of elements, or of items: to its end, or to a mark.
  struct Stretch {
    std::uint64_t end = 0;
    bool is_open = false;
    bool is_top = false;
    int depth = 0;
  };

  /// Behind the mark; or at the first byte where a low group stands there.
  void require_begin() {
    if (has_mark(source_)) {
      offset_ = kMarkOffset + kMark.size();
      return;
    }
    const std::string_view front = source_.peek(0, 2);
    const std::uint32_t group =
        std::min(number_of_bytes(front, false), number_of_bytes(front, true));
    if (group >= 2 && group <= 0x28) return;
    if (source_.size() < kMarkOffset + kMark.size()) require_bytes(kMarkOffset + kMark.size());
    refuse(source_.file(), "this is no DICOM file", "DICM behind a preamble of 128 bytes");
  }

  /// Group 0002, always in explicit VR and little endian. A file may not end behind it either.
  void pass_file_header() {
    while (true) {
      const ElementHead head = next(source_.size());
      if (head.tag >> 16 != 2) return;
      if (head.is_open()) refuse_broken();
      require_bytes(head.bytes + head.length);
      const std::uint64_t value = offset_ + head.bytes;
      if (head.tag == 0x00020010) header_.transfer_syntax = uid_at(value, head.length);
      if (head.tag == 0x00020002) header_.storage_class = uid_at(value, head.length);
      offset_ = value + head.length;
    }
  }

  std::string uid_at(std::uint64_t offset, std::uint32_t length) {
    constexpr std::uint32_t kLongestUid = 64;
    return printable(source_.read(offset, std::min(length, kLongestUid)));
  }

  void unpack() {
    Unpacked unpacked = unpack_deflated(source_, offset_, most_unpacked_bytes_);
    header_.is_partly_unpacked = unpacked.is_partial;
    source_.replace_by(std::move(unpacked.bytes));
    offset_ = 0;
  }

  /// By the first element, for what the syntax says is not always so.
  void find_encoding() {
    const std::string_view front = source_.peek(offset_, kShortHead);
    encoding_.has_vr = is_known_vr(front.substr(4, 2));
    encoding_.is_big_endian = front[0] == '\0' && front[1] != '\0';
    if (!encoding_.has_vr) encoding_.is_big_endian = false;
  }

  void pass_elements(const Stretch& stretch, DicomItem* kept) {
    if (stretch.depth > kDeepest) refuse_broken();
    while (offset_ < stretch.end) {
      if (stretch.is_top && is_trailing()) return;
      if (!stretch.is_top && stretch.end - offset_ < kShortHead) refuse_broken();
      const ElementHead head = next(stretch.end);
      if (stretch.is_top && is_pixel_data(head.tag)) return note_pixels(head);
      offset_ += head.bytes;
      if (head.tag == kItemEnd) return;
      if (head.is_delimiter()) continue;
      pass_value(head, stretch, is_kept(head.tag) ? kept : nullptr);
    }
    if (stretch.is_open) require_bytes(kShortHead);
  }

  /// Sequences are known by their VR; and without one, by the item that they begin with.
  void pass_value(const ElementHead& head, const Stretch& within, DicomItem* kept) {
    if (!head.is_open() && head.length > within.end - offset_) {
      within.is_top ? require_bytes(head.length) : refuse_broken();
    }
    DicomElement* element = kept ? &keep(head, *kept) : nullptr;
    const std::uint64_t end = head.is_open() ? within.end : offset_ + head.length;
    const bool has_no_vr = head.vr[0] == '\0' || head.has_vr("UN");
    const bool is_sequence = head.has_vr("SQ") || (has_no_vr && (head.is_open() || begins_item()));
    if (head.is_open() || (is_sequence && element)) {
      const DicomEncoding outside = encoding_;
      if (head.has_vr("UN")) encoding_ = {.has_vr = false, .is_big_endian = false};
      pass_items({end, head.is_open(), false, within.depth + 1}, is_sequence,
                 is_sequence ? element : nullptr);
      encoding_ = outside;
    }
    if (!head.is_open()) offset_ = end;
  }

  bool begins_item() {
    return number_of_bytes(source_.peek(offset_, 2), encoding_.is_big_endian) == 0xFFFE &&
           number_of_bytes(source_.peek(offset_ + 2, 2), encoding_.is_big_endian) == 0xE000;
  }

  void pass_items(const Stretch& stretch, bool of_elements, DicomElement* kept) {
    while (offset_ < stretch.end) {
      const ElementHead head = next(stretch.end);
      offset_ += head.bytes;
      if (head.tag == kSequenceEnd) return;
      if (head.tag != kItem) {
        offset_ -= head.bytes;
        refuse_broken();
      }
      if (!head.is_open() && head.length > stretch.end - offset_) refuse_broken();
      const std::uint64_t end = head.is_open() ? stretch.end : offset_ + head.length;
      DicomItem* item = kept ? &kept->items.emplace_back() : nullptr;
      count_one();
      if (head.is_open() || (of_elements && item))
        pass_elements({end, head.is_open(), false, stretch.depth + 1}, item);
      if (!head.is_open()) offset_ = end;
    }
    if (stretch.is_open) require_bytes(kShortHead);
  }

  DicomElement& keep(const ElementHead& head, DicomItem& item) {
    count_one();
    return item.elements.emplace_back(DicomElement{.tag = head.tag,
                                                   .vr = head.vr,
                                                   .is_big_endian = encoding_.is_big_endian,
                                                   .length = head.is_open() ? 0 : head.length,
                                                   .offset = offset_,
                                                   .items = {}});
  }

  void count_one() {
    if (++elements_ <= kMostElements) return;
    refuse(source_.file(), "the DICOM header is too long",
           fmt::format("at most {} elements before the pixels", kMostElements));
  }

  void note_pixels(const ElementHead& head) {
    const bool is_open = head.is_open();
    header_.pixels = DicomPixelElement{head.tag, head.vr, offset_ + head.bytes,
                                       is_open ? 0 : head.length, is_open};
  }

  ElementHead next(std::uint64_t end) {
    require_bytes(kShortHead);
    const ElementHead head =
        element_head(source_.peek(offset_, kLongHead), encoding_, end - offset_);
    require_bytes(head.bytes);
    return head;
  }

  /// A few bytes of filling behind the last element.
  bool is_trailing() {
    const std::uint64_t left = source_.size() - offset_;
    return left < kShortHead && source_.peek(offset_, left) == std::string(left, '\0');
  }

  void require_bytes(std::uint64_t bytes) const {
    if (bytes <= source_.size() - offset_) return;
    if (header_.is_partly_unpacked) {
      refuse(source_.file(), "the DICOM header is too long",
             bytes_in_words(static_cast<double>(most_unpacked_bytes_)));
    }
    refuse(source_.file(), "the DICOM header is cut off",
           fmt::format("at least {} bytes", offset_ + bytes),
           fmt::format("{} bytes", source_.size()));
  }

  [[noreturn]] void refuse_broken() const {
    refuse(source_.file(), "the DICOM header is broken", "an element of DICOM",
           fmt::format("something else at byte {}", offset_));
  }

  ByteSource& source_;
  std::uint64_t most_unpacked_bytes_;
  DicomHeader header_;
  DicomEncoding encoding_;
  std::uint64_t offset_ = 0;
  std::size_t elements_ = 0;
};

}  // namespace

const DicomElement* DicomItem::find(DicomTag tag) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [tag](const DicomElement& e) { return e.tag == tag; });
  return found == elements.end() ? nullptr : &*found;
}

DicomHeader read_dicom_header(ByteSource& source, std::uint64_t most_unpacked_bytes) {
  return HeaderWalk(source, most_unpacked_bytes).run();
}

/// Three elements in rising order, of group 2 or 8, are no accident.
bool looks_like_dicom(const std::filesystem::path& file) {
  try {
    ByteSource source(file);
    if (has_mark(source)) return true;
    const std::string_view front = source.peek(0, kShortHead);
    const bool is_big_endian = front[0] == '\0';
    const DicomEncoding encoding{is_known_vr(front.substr(4, 2)), is_big_endian};
    std::uint64_t offset = 0;
    DicomTag last = 0x00020000 - 1;
    for (int i = 0; i < 3; ++i) {
      if (offset + kLongHead > source.size()) return false;
      const ElementHead head =
          element_head(source.peek(offset, kLongHead), encoding, source.size() - offset);
      const std::uint32_t group = head.tag >> 16;
      const bool is_plausible = head.tag > last && (group == 2 || group == 8) &&
                                (head.vr[0] != '\0') == encoding.has_vr && !head.is_open() &&
                                head.length % 2 == 0 &&
                                head.length <= source.size() - offset - head.bytes;
      if (!is_plausible) return false;
      last = head.tag;
      offset += head.bytes + head.length;
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace cutaway::reading
