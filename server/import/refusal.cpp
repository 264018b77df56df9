#include "import/refusal.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace cutaway::reading {

namespace {

/// Of any scanner by far; keeps each extent an int and a table by slice small.
constexpr std::int64_t kLargestExtent = 32768;

std::string extents_in_words(std::span<const std::int64_t> extents) {
  std::string text;
  for (const auto extent : extents) text += (text.empty() ? "" : "x") + std::to_string(extent);
  return text;
}

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

void refuse(const std::filesystem::path& file, std::string message, std::string expected,
            std::string received) {
  throw Error({.code = ErrorCode::volume_refused,
               .message = std::move(message),
               .field = file.string(),
               .expected = std::move(expected),
               .received = quoted_briefly(std::move(received))});
}

std::string quoted_briefly(std::string text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && continues_character(text[bytes])) --bytes;
  text.resize(bytes);
  return text + "...";
}

std::string reason_of(const Error& error) {
  Error::Detail detail = error.detail();
  detail.field.clear();
  return Error(detail).what();
}

std::uint64_t checked_voxel_count(const std::filesystem::path& file,
                                  std::span<const std::int64_t> extents,
                                  std::uint64_t bytes_per_voxel, const ImportLimits& limits) {
  constexpr std::uint64_t kLeastStoredBytes = sizeof(std::uint16_t);  // as a Volume keeps them
  double bytes = static_cast<double>(std::max(bytes_per_voxel, kLeastStoredBytes));
  for (const auto extent : extents) {
    if (extent < 1) {
      refuse(file, "the header declares an empty grid", "at least 1 voxel along each axis",
             extents_in_words(extents));
    }
    bytes *= static_cast<double>(extent);
  }
  if (bytes > static_cast<double>(limits.volume_bytes)) {
    throw Error(
        {.code = ErrorCode::too_large,
         .message = "the volume is too large",
         .field = file.string(),
         .expected = "at most " + bytes_in_words(static_cast<double>(limits.volume_bytes)),
         .received = bytes_in_words(bytes) + " (" + extents_in_words(extents) + " voxels)"});
  }
  std::uint64_t count = 1;
  for (const auto extent : extents) {
    if (extent > kLargestExtent) {
      refuse(file, "the grid is too long along one axis",
             "at most " + std::to_string(kLargestExtent) + " voxels", extents_in_words(extents));
    }
    count *= static_cast<std::uint64_t>(extent);
  }
  return count;
}

void require_volume_extents(const std::filesystem::path& file, glm::ivec3 size_voxels) {
  if (size_voxels.x > 1 && size_voxels.y > 1 && size_voxels.z > 1) return;
  refuse(file, "a single slice is no volume", "at least 2 voxels along each axis",
         fmt::format("{}x{}x{}", size_voxels.x, size_voxels.y, size_voxels.z));
}

std::string bytes_in_words(double bytes) {
  if (bytes < 1024) return fmt::format("{:.0f} bytes", bytes);
  constexpr std::array kUnits{"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  std::size_t unit = 0;
  double amount = bytes / 1024;
  for (; amount >= 1024 && unit + 1 < kUnits.size(); ++unit) amount /= 1024;
  return fmt::format("{:.1f} {}", amount, kUnits.at(unit));
}

std::string counted(std::uint64_t count, const std::string& noun, const std::string& plural) {
  if (count == 1) return "1 " + noun;
  return fmt::format("{} {}", count, plural.empty() ? noun + "s" : plural);
}

std::string number_in_words(double number) { return fmt::format("{}", number); }

}  // namespace cutaway::reading
