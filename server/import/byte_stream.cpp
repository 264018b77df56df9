#include "import/byte_stream.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <utility>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

constexpr std::size_t kPieceBytes = std::size_t{256} << 10;
constexpr int kZlibOrGzip = 15 + 32;

}  // namespace

bool has_gzip_magic(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return input.get() == 0x1F && input.get() == 0x8B;
}

/// Owns a z_stream and the input that it has yet to take.
struct ByteStream::Inflater {
  Inflater() : input(kPieceBytes), usable(inflateInit2(&stream, kZlibOrGzip) == Z_OK) {}
  ~Inflater() { inflateEnd(&stream); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream stream{};
  std::vector<std::byte> input;
  bool usable;
  bool at_member = false;  ///< one stream has ended
};

ByteStream::ByteStream(std::filesystem::path file, std::uint64_t begin, bool compressed)
    : path_(std::move(file)), file_(path_, std::ios::binary), consumed_(begin) {
  std::error_code failed;
  file_bytes_ = std::filesystem::file_size(path_, failed);
  file_.seekg(static_cast<std::streamoff>(begin));
  if (failed || !file_) refuse(path_, "the file cannot be read");
  if (compressed) inflater_ = std::make_unique<Inflater>();
  if (compressed && !inflater_->usable) refuse(path_, "zlib cannot be set up");
}

ByteStream::~ByteStream() = default;
ByteStream::ByteStream(ByteStream&&) noexcept = default;

std::size_t ByteStream::read(std::span<std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto rest = bytes.subspan(done);
    const std::size_t got = inflater_ ? inflate_some(rest) : read_file(rest);
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

std::size_t ByteStream::inflate_some(std::span<std::byte> bytes) {
  z_stream& stream = inflater_->stream;
  const std::size_t wanted = std::min(bytes.size(), kPieceBytes);
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(wanted);
  while (stream.avail_out == wanted) {
    if (stream.avail_in == 0) {
      stream.next_in = reinterpret_cast<Bytef*>(inflater_->input.data());
      stream.avail_in = static_cast<uInt>(read_file(inflater_->input));
      if (stream.avail_in == 0) break;  // cut off: the caller sees too few bytes
    }
    // Another member may follow in a gzip file; anything else after the stream is no part of it.
    if (inflater_->at_member && *stream.next_in != 0x1F) break;
    inflater_->at_member = false;
    const int result = inflate(&stream, Z_NO_FLUSH);
    if (result == Z_STREAM_END) {
      inflater_->at_member = true;
      inflateReset(&stream);
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      refuse(path_, "the compressed data are broken", {}, stream.msg ? stream.msg : "");
    }
  }
  return wanted - stream.avail_out;
}

}  // namespace cutaway::reading
