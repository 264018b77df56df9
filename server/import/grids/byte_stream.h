// A file's bytes from front to back, decompressed where they are compressed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "import/decompressor.h"

namespace cutaway::reading {

/// The magic of gzip (RFC 1952).
bool has_gzip_magic(const std::filesystem::path& file);

/// Also where several compressed streams follow each other. Throws Error naming the file where it
/// cannot be read or a stream is broken. One thread at a time.
class ByteStream {
 public:
  ByteStream(std::filesystem::path file, std::uint64_t begin, Compression compression);

  /// Fills as much of `bytes` as there is; returns how many.
  std::size_t read(std::span<std::byte> bytes);

  /// Passes over bytes; false where the stream ends before.
  bool skip(std::uint64_t bytes);

  /// How much of the file was consumed, 0..1.
  double fraction_consumed() const;

 private:
  std::size_t read_file(std::span<std::byte> bytes);
  bool refill_input();
  std::size_t decompress_some(std::span<std::byte> bytes);

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t consumed_ = 0;
  std::unique_ptr<Decompressor> decompressor_;  ///< none where the file's bytes are the data
  std::vector<std::byte> input_buffer_;
  std::span<const std::byte> input_;  ///< of the buffer, what is still to be decompressed
  bool between_streams_ = false;
};

}  // namespace cutaway::reading
