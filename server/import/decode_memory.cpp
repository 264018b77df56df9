#include "import/decode_memory.h"

#include <algorithm>

#include "volume/parallel.h"

namespace cutaway::reading {

namespace {

/// Decoded pixels are there four times at worst: as in the file, in the codec, as an image, as
/// bytes.
constexpr std::uint64_t kCopies = 4;
constexpr std::uint64_t kMostBytesSideBySide = std::uint64_t{1} << 30;
/// More would wait for memory, not for codecs.
constexpr std::uint64_t kMostThreads = 8;
constexpr std::uint64_t kStackBytes = std::uint64_t{16} << 20;

}  // namespace

int decode_threads(std::uint64_t decoded_bytes_of_a_file) {
  const std::uint64_t each = kCopies * std::max<std::uint64_t>(decoded_bytes_of_a_file, 1);
  const std::uint64_t fit = std::clamp<std::uint64_t>(kMostBytesSideBySide / each, 1, kMostThreads);
  return std::min(static_cast<int>(fit), default_thread_count());
}

std::uint64_t decode_memory_bytes(std::uint64_t decoded_bytes_of_a_file) {
  const auto threads = static_cast<std::uint64_t>(decode_threads(decoded_bytes_of_a_file));
  return threads * (kCopies * decoded_bytes_of_a_file + kStackBytes);
}

}  // namespace cutaway::reading
