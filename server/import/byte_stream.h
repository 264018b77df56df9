// A file's bytes from front to back, inflated where they are compressed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

namespace cutaway::reading {

/// No deflate stream expands further (RFC 1951: at best 258 bytes for two bits).
inline constexpr double kLargestDeflateRatio = 1032.0;

/// The magic of gzip (RFC 1952).
bool has_gzip_magic(const std::filesystem::path& file);

/// zlib and gzip streams alike, gzip also of several members. Throws Error naming the file where it
/// cannot be read or the stream is broken. One thread at a time.
class ByteStream {
 public:
  ByteStream(std::filesystem::path file, std::uint64_t begin, bool compressed);
  ~ByteStream();
  ByteStream(ByteStream&&) noexcept;

  /// Fills as much of `bytes` as there is; returns how many.
  std::size_t read(std::span<std::byte> bytes);

  /// Passes over bytes; false where the stream ends before.
  bool skip(std::uint64_t bytes);

  /// How much of the file was consumed, 0..1.
  double fraction_consumed() const;

 private:
  struct Inflater;
  std::size_t read_file(std::span<std::byte> bytes);
  std::size_t inflate_some(std::span<std::byte> bytes);

  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t file_bytes_ = 0;
  std::uint64_t consumed_ = 0;
  std::unique_ptr<Inflater> inflater_;
};

}  // namespace cutaway::reading
