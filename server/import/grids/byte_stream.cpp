#include "import/grids/byte_stream.h"

#include <algorithm>
#include <array>
#include <utility>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::size_t kInputPieceBytes = std::size_t{256} << 10;

}  // namespace

bool has_gzip_magic(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return input.get() == 0x1F && input.get() == 0x8B;
}

ByteStream::ByteStream(std::filesystem::path file, std::uint64_t begin, Compression compression)
    : path_(std::move(file)), file_(path_, std::ios::binary), consumed_(begin) {
  std::error_code failed;
  file_bytes_ = std::filesystem::file_size(path_, failed);
  file_.seekg(static_cast<std::streamoff>(begin));
  if (failed || !file_) refuse(path_, "the file cannot be read");
  if (compression != Compression::none) decompressor_ = make_decompressor(path_, compression);
}

std::size_t ByteStream::read(std::span<std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto rest = bytes.subspan(done);
    const std::size_t got = decompressor_ ? decompress_some(rest) : read_file(rest);
    if (got == 0) break;
    done += got;
  }
  return done;
}

bool ByteStream::skip(std::uint64_t bytes) {
  std::array<std::byte, 4096> piece{};
  while (bytes > 0) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), bytes));
    if (read(std::span(piece).first(wanted)) < wanted) return false;
    bytes -= wanted;
  }
  return true;
}

double ByteStream::fraction_consumed() const {
  if (file_bytes_ == 0) return 1.0;
  return std::min(1.0, static_cast<double>(consumed_) / static_cast<double>(file_bytes_));
}

std::size_t ByteStream::read_file(std::span<std::byte> bytes) {
  file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto got = static_cast<std::size_t>(file_.gcount());
  consumed_ += got;
  return got;
}

bool ByteStream::refill_input() {
  input_buffer_.resize(kInputPieceBytes);
  input_ = std::span(input_buffer_).first(read_file(input_buffer_));
  return !input_.empty();
}

std::size_t ByteStream::decompress_some(std::span<std::byte> bytes) {
  const std::size_t wanted = std::min(bytes.size(), kInputPieceBytes);
  std::span<std::byte> output = bytes.first(wanted);
  while (output.size() == wanted) {
    if (input_.empty() && !refill_input()) break;  // cut off: the caller sees too few bytes
    if (between_streams_ && !decompressor_->may_begin_with(input_.front())) break;
    between_streams_ = decompressor_->step(input_, output);
  }
  return wanted - output.size();
}

}  // namespace cutaway::reading
