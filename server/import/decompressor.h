// The compressed streams that volume files hold, taken a piece at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace cutaway::reading {

enum class Compression { none, deflate, bzip2 };

/// The most bytes that one byte of such a stream can become: for deflate 258 bytes for two bits
/// (RFC 1951), for bzip2 blocks of 900,000 bytes, each of which stands for up to 52, in 33 bytes.
double largest_ratio(Compression compression);

/// One decoder. A file may hold several streams in a row; `step` begins the next by itself.
class Decompressor {
 public:
  virtual ~Decompressor() = default;

  /// Takes from the front of `input`, fills the front of `output`, and moves both on; neither may
  /// be empty. True where a stream ended. Throws Error naming the file where it is broken.
  virtual bool step(std::span<const std::byte>& input, std::span<std::byte>& output) = 0;

  /// Whether another stream may begin with that byte; else what follows is no part of the data.
  virtual bool may_begin_with(std::byte first) const = 0;
};

/// zlib and gzip are both Compression::deflate. Throws Error naming `file` where the decoder cannot
/// be set up. `compression` is not none.
std::unique_ptr<Decompressor> make_decompressor(const std::filesystem::path& file,
                                                Compression compression);

}  // namespace cutaway::reading
