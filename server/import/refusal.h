// How readers say no: one plain sentence that names the file, what was expected and what came.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "core/error.h"
#include "import/reader.h"

namespace cutaway::reading {

/// Throws Error "volume-refused" with `file` as its field. What came is cut to kLongestQuote, for
/// it may be a whole file.
[[noreturn]] void refuse(const std::filesystem::path& file, std::string message,
                         std::string expected = {}, std::string received = {});

/// Bytes of what a file says that a sentence repeats, and of the sentence.
inline constexpr std::size_t kLongestQuote = 100;
inline constexpr std::size_t kLongestReason = 600;

/// The text, or its beginning and "..." where it is longer; cuts no character of UTF-8 in two.
std::string quoted_briefly(std::string text, std::size_t bytes = kLongestQuote);

/// The sentence of an Error without its field: a listing shows the path next to it.
std::string reason_of(const Error& error);

/// Number of voxels of a grid that a header declares. Throws Error "volume-refused" for an extent
/// below 1, and "too-large" where voxels * bytes_per_voxel exceeds the limit, or what a Volume
/// makes of them; no product overflows.
std::uint64_t checked_voxel_count(const std::filesystem::path& file,
                                  std::span<const std::int64_t> extents,
                                  std::uint64_t bytes_per_voxel, const ImportLimits& limits);

/// Throws Error "volume-refused" where the grid is too thin to be a volume: every axis wants two
/// voxels.
void require_volume_extents(const std::filesystem::path& file, glm::ivec3 size_voxels);

/// "12.5 GiB", "452 bytes"
std::string bytes_in_words(double bytes);

/// "1 slice", "12 slices"; `plural` where it is not by an s.
std::string counted(std::uint64_t count, const std::string& noun, const std::string& plural = {});

/// Shortest decimal text that reads back as the same number.
std::string number_in_words(double number);

}  // namespace cutaway::reading
