// Bytes by their place, in a file or unpacked from one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cutaway::reading {

/// Reads a file in pieces, for elements of a header lie close to each other. One thread.
class ByteSource {
 public:
  /// Throws Error where the file cannot be opened.
  explicit ByteSource(std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }
  std::uint64_t size() const { return size_; }

  /// What comes from here on is `bytes` instead of the file's, from place 0 on.
  void replace_by(std::string bytes);

  /// Gives back what is unpacked up to there; it is not read again.
  void forget_before(std::uint64_t offset);

  /// At most kMostPeeked of them; zeros behind the end. Valid until the next call.
  std::string_view peek(std::uint64_t offset, std::uint64_t bytes);
  static constexpr std::uint64_t kMostPeeked = 4096;

  /// Throws Error naming the file where it ends before them.
  void read(std::uint64_t offset, std::span<char> target);
  std::string read(std::uint64_t offset, std::uint64_t bytes);

 private:
  static constexpr std::uint64_t kPieceBytes = 16384;

  void require(std::uint64_t offset, std::uint64_t bytes) const;
  void fill(std::uint64_t offset);
  void copy(std::uint64_t offset, std::span<char> target);

  std::filesystem::path file_;
  std::ifstream input_;
  std::string unpacked_;
  bool is_unpacked_ = false;
  std::uint64_t forgotten_ = 0;
  std::uint64_t size_ = 0;
  std::vector<char> piece_;
  std::uint64_t begin_ = 0;
  bool is_filled_ = false;
};

}  // namespace cutaway::reading
