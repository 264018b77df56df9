// The file that a command's work goes to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cutaway {

/// Throws Error where the file could not be written, as far as that shows before the work is done.
/// Creates nothing.
void check_writable(const std::filesystem::path& file);

/// Throws Error.
void write_file(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes);

}  // namespace cutaway
