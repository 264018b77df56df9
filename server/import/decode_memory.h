// How many files of a volume are decoded side by side, and what that takes beside the voxels.
#pragma once

#include <cstdint>

namespace cutaway::reading {

/// As many as the machine has cores, and fewer where a file's decoded pixels are large: together
/// they stay within a bound that one such file may exceed alone.
int decode_threads(std::uint64_t decoded_bytes_of_a_file);

/// Address space that they take in a process with one arena of the allocator, stacks included.
std::uint64_t decode_memory_bytes(std::uint64_t decoded_bytes_of_a_file);

}  // namespace cutaway::reading
