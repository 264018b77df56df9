#include "import/dicom/byte_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "core/released_pages.h"
#include "import/refusal.h"

namespace cutaway::reading {

ByteSource::ByteSource(std::filesystem::path file)
    : file_(std::move(file)), input_(file_, std::ios::binary), piece_(kPieceBytes) {
  std::error_code failed;
  size_ = std::filesystem::file_size(file_, failed);
  if (failed || !input_) refuse(file_, "the file cannot be opened");
}

void ByteSource::replace_by(std::string bytes) {
  unpacked_ = std::move(bytes);
  is_unpacked_ = true;
  is_filled_ = false;
  size_ = unpacked_.size();
}

void ByteSource::forget_before(std::uint64_t offset) {
  const std::uint64_t end = std::min<std::uint64_t>(offset, unpacked_.size());
  if (end <= forgotten_) return;
  const auto unpacked = std::as_writable_bytes(std::span(unpacked_));
  release_pages(unpacked.subspan(forgotten_, end - forgotten_));
  forgotten_ = end;
}

std::string_view ByteSource::peek(std::uint64_t offset, std::uint64_t bytes) {
  check(bytes <= kMostPeeked, "a peek is short");
  if (!is_filled_ || offset < begin_ || offset - begin_ > kPieceBytes - bytes) fill(offset);
  return std::string_view(piece_.data(), piece_.size()).substr(offset - begin_, bytes);
}

void ByteSource::read(std::uint64_t offset, std::span<char> target) {
  require(offset, target.size());
  copy(offset, target);
}

std::string ByteSource::read(std::uint64_t offset, std::uint64_t bytes) {
  require(offset, bytes);
  if (bytes <= kMostPeeked) return std::string(peek(offset, bytes));
  std::string text(bytes, '\0');
  copy(offset, text);
  return text;
}

void ByteSource::require(std::uint64_t offset, std::uint64_t bytes) const {
  if (offset <= size_ && bytes <= size_ - offset) return;
  refuse(file_, "the file is cut off", fmt::format("{} bytes from byte {} on", bytes, offset),
         fmt::format("{} bytes", size_));
}

void ByteSource::fill(std::uint64_t offset) {
  std::fill(piece_.begin(), piece_.end(), '\0');
  const std::uint64_t left = offset < size_ ? size_ - offset : 0;
  copy(offset, std::span(piece_).first(std::min<std::uint64_t>(left, kPieceBytes)));
  begin_ = offset;
  is_filled_ = true;
}

void ByteSource::copy(std::uint64_t offset, std::span<char> target) {
  if (target.empty()) return;
  if (is_unpacked_) {
    std::copy_n(unpacked_.begin() + static_cast<std::ptrdiff_t>(offset), target.size(),
                target.begin());
    return;
  }
  input_.clear();
  input_.seekg(static_cast<std::streamoff>(offset));
  input_.read(target.data(), static_cast<std::streamsize>(target.size()));
  if (!input_) refuse(file_, "the file cannot be read");
}

}  // namespace cutaway::reading
