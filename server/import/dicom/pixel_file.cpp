#include "import/dicom/pixel_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "import/data_root.h"
#include "import/dicom/codestream.h"
#include "import/dicom/element_head.h"
#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::size_t kMostFragments = std::size_t{1} << 20;

std::uint64_t bytes_of_frames(const DicomImage& image) {
  return std::uint64_t(image.size_px.x) * image.size_px.y * component_bytes(image.component) *
         static_cast<std::uint64_t>(image.frames);
}

/// Elements of `bytes_each` bytes, the other way round.
void swap_bytes(std::string& bytes, std::size_t bytes_each) {
  swap_byte_order(std::as_writable_bytes(std::span(bytes)), bytes_each);
}

}  // namespace

PixelFile::PixelFile(std::shared_ptr<const DicomImage> image)
    : image_(std::move(image)),
      source_(image_->file),
      header_(read_dicom_header(source_, kMostUnpackedHeaderBytes + bytes_of_frames(*image_))) {
  if (!header_.pixels) refuse(image_->file, "the image has no pixel data");
  packing_ =
      required_packing(image_->file, header_.transfer_syntax, header_.pixels->is_in_fragments);
  is_big_endian_ = header_.is_big_endian || has_big_endian_pixels(header_.transfer_syntax);
  const CharacterSet none;
  read_bits(DataSet(source_, header_.data, none));
  if (header_.pixels->is_in_fragments) {
    find_fragments();
  } else if (header_.pixels->length < bytes_of_frames(*image_)) {
    refuse(image_->file, "the pixel data are broken or cut off",
           bytes_in_words(static_cast<double>(bytes_of_frames(*image_))),
           bytes_in_words(static_cast<double>(header_.pixels->length)));
  }
}

std::uint64_t PixelFile::frame_bytes() const {
  return bytes_of_frames(*image_) / static_cast<std::uint64_t>(image_->frames);
}

void PixelFile::read_bits(const DataSet& data) {
  const auto number = [&](DicomTag tag, int otherwise) {
    return static_cast<int>(data.binary(tag).value_or(otherwise));
  };
  bits_.allocated = static_cast<int>(component_bytes(image_->component)) * 8;
  bits_.stored = number(0x00280101, bits_.allocated);
  bits_.high_bit = number(0x00280102, bits_.stored - 1);
  bits_.is_signed = number(0x00280103, 0) == 1;
  const bool are_floats = header_.pixels->tag != 0x7FE00010;
  const bool usable = bits_.stored >= 1 && bits_.stored <= bits_.allocated &&
                      bits_.high_bit < bits_.allocated && bits_.high_bit + 1 >= bits_.stored;
  if (usable || are_floats) return;
  refuse(image_->file, "the pixels' bits are not usable",
         fmt::format("at most {} bits", bits_.allocated),
         fmt::format("{} bits stored, high bit {}", bits_.stored, bits_.high_bit));
}

PixelFile::Place PixelFile::next_fragment(std::uint64_t& offset) {
  const std::string_view head = source_.peek(offset, kShortHead);
  const std::uint32_t tag = number_of_bytes(head.substr(0, 2), is_big_endian_) << 16 |
                            number_of_bytes(head.substr(2, 2), is_big_endian_);
  const Place place{offset + kShortHead, number_of_bytes(head.substr(4, 4), is_big_endian_)};
  const bool fits = source_.size() >= place.offset && place.bytes <= source_.size() - place.offset;
  if (tag == kItem && fits) {
    offset = place.offset + place.bytes;
    return place;
  }
  if (tag != kSequenceEnd) refuse(image_->file, "the pixel data are broken or cut off");
  return {};
}

/// The first item is the Basic Offset Table. Source: DICOM PS3.5, A.4.
void PixelFile::find_fragments() {
  std::uint64_t offset = header_.pixels->offset;
  const Place table = next_fragment(offset);
  const std::uint64_t first = offset;
  while (true) {
    const Place fragment = next_fragment(offset);
    if (fragment.offset == 0) break;
    fragments_.push_back(fragment);
    if (fragments_.size() > kMostFragments)
      refuse(image_->file, "the pixel data are in too many fragments",
             fmt::format("at most {}", kMostFragments));
  }
  std::vector<std::uint64_t> offsets;
  const std::uint64_t frames = static_cast<std::uint64_t>(image_->frames);
  for (std::uint64_t i = 0; i < std::min(table.bytes / 4, frames); ++i) {
    const std::string_view entry = source_.peek(table.offset + 4 * i, 4);
    offsets.push_back(first + kShortHead + number_of_bytes(entry, is_big_endian_));
  }
  share_out(offsets);
}

void PixelFile::share_out(const std::vector<std::uint64_t>& offsets) {
  const auto frames = static_cast<std::size_t>(image_->frames);
  if (fragments_.size() == frames) {
    first_fragment_.resize(frames);
    std::iota(first_fragment_.begin(), first_fragment_.end(), std::size_t{0});
  } else if (frames == 1 && !fragments_.empty()) {
    first_fragment_ = {0};
  } else if (offsets.size() == frames) {
    share_out_by_offsets(offsets);
  } else {
    share_out_by_pictures();
  }
  if (first_fragment_.size() != frames) {
    refuse(image_->file, "the pixel data are broken or cut off", fmt::format("{} frames", frames),
           fmt::format("{} fragments", fragments_.size()));
  }
  first_fragment_.push_back(fragments_.size());
}

void PixelFile::share_out_by_offsets(const std::vector<std::uint64_t>& offsets) {
  for (const std::uint64_t offset : offsets) {
    const auto found =
        std::lower_bound(fragments_.begin(), fragments_.end(), offset,
                         [](const Place& place, std::uint64_t at) { return place.offset < at; });
    const auto index = static_cast<std::size_t>(found - fragments_.begin());
    const bool rises = first_fragment_.empty() || index > first_fragment_.back();
    if (found == fragments_.end() || found->offset != offset || !rises) return;
    first_fragment_.push_back(index);
  }
}

void PixelFile::share_out_by_pictures() {
  for (std::size_t i = 0; i < fragments_.size(); ++i) {
    const std::uint64_t bytes = std::min<std::uint64_t>(fragments_[i].bytes, kShortHead);
    if (begins_picture(source_.peek(fragments_[i].offset, bytes), packing_))
      first_fragment_.push_back(i);
  }
}

/// Of its largest part, where it is in several.
PixelFile::Place PixelFile::place_of(int frame) const {
  const auto index = static_cast<std::size_t>(frame);
  if (!header_.pixels->is_in_fragments)
    return {header_.pixels->offset + index * frame_bytes(), frame_bytes()};
  const auto begin = fragments_.begin();
  return *std::max_element(begin + static_cast<std::ptrdiff_t>(first_fragment_[index]),
                           begin + static_cast<std::ptrdiff_t>(first_fragment_[index + 1]),
                           [](const Place& a, const Place& b) { return a.bytes < b.bytes; });
}

std::string PixelFile::glimpse(int frame) {
  const Place place = place_of(frame);
  const std::uint64_t count = std::min(place.bytes, ByteSource::kMostPeeked);
  const std::string_view middle = source_.peek(place.offset + (place.bytes - count) / 2, count);
  return fmt::format("{} {}", place.bytes, short_hash(middle));
}

std::string PixelFile::packed(int frame) {
  const auto index = static_cast<std::size_t>(frame);
  if (!header_.pixels->is_in_fragments)
    return source_.read(header_.pixels->offset + index * frame_bytes(), frame_bytes());
  std::string bytes;
  for (std::size_t i = first_fragment_[index]; i < first_fragment_[index + 1]; ++i)
    bytes += source_.read(fragments_[i].offset, fragments_[i].bytes);
  return bytes;
}

void PixelFile::forget(int frame) {
  const Place place = place_of(frame);
  source_.forget_before(place.offset + place.bytes);
}

PlainFrame PixelFile::plain(int frame) {
  if (header_.pixels->is_in_fragments) {
    return unpacked({image_->file, header_.transfer_syntax, packing_, image_->size_px.x,
                     image_->size_px.y, bits_, packed(frame)});
  }
  PlainFrame plain{packed(frame), bits_};
  const std::size_t bytes_each = component_bytes(image_->component);
  const bool is_of_words = std::string_view(header_.pixels->vr.data(), 2) == "OW";
  if (is_big_endian_) swap_bytes(plain.bytes, bytes_each == 1 && is_of_words ? 2 : bytes_each);
  return plain;
}

}  // namespace cutaway::reading
