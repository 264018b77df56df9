#include "import/dicom/deflated.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

class RawInflater {
 public:
  RawInflater(const std::filesystem::path& file, bool has_zlib_header) {
    if (inflateInit2(&stream_, has_zlib_header ? MAX_WBITS : -MAX_WBITS) != Z_OK)
      refuse(file, "zlib cannot be set up");
  }
  ~RawInflater() { inflateEnd(&stream_); }
  RawInflater(const RawInflater&) = delete;
  RawInflater& operator=(const RawInflater&) = delete;

  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
};

/// Some writers leave it, against the standard.
bool has_zlib_header(ByteSource& source, std::uint64_t offset) {
  const std::string_view front = source.peek(offset, 2);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(front[i]); };
  return byte(0) == 0x78 && (byte(0) * 256 + byte(1)) % 31 == 0;
}

}  // namespace

Unpacked unpack_deflated(ByteSource& source, std::uint64_t offset, std::uint64_t most_bytes) {
  constexpr std::uint64_t kPiece = 65536;
  RawInflater inflater(source.file(), has_zlib_header(source, offset));
  z_stream& stream = inflater.stream();
  Unpacked unpacked;
  constexpr std::uint64_t kLargestRatio = 1032;  // 258 bytes for two bits
  unpacked.bytes.reserve(std::min(most_bytes, (source.size() - offset) * kLargestRatio) + kPiece);
  std::string input;
  std::array<char, kPiece> output{};
  for (int result = Z_OK; result != Z_STREAM_END;) {
    if (stream.avail_in == 0 && offset < source.size()) {
      input = source.read(offset, std::min(kPiece, source.size() - offset));
      offset += input.size();
      stream.next_in = reinterpret_cast<Bytef*>(input.data());
      stream.avail_in = static_cast<uInt>(input.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(output.data());
    stream.avail_out = kPiece;
    result = inflate(&stream, Z_NO_FLUSH);
    const std::size_t made = kPiece - stream.avail_out;
    unpacked.bytes.append(output.data(), made);
    if (unpacked.bytes.size() > most_bytes) {
      unpacked.is_partial = true;
      return unpacked;
    }
    if (result == Z_BUF_ERROR && made == 0) return unpacked;  // cut off: for the walk to say
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
      refuse(source.file(), "the deflated data are broken", {}, stream.msg ? stream.msg : "");
  }
  return unpacked;
}

}  // namespace cutaway::reading
