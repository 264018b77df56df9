// Voxels from one process to another through a file in memory, of which each piece is in one place
// at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "import/isolation/child_process.h"

namespace cutaway::reading {

/// Throws std::runtime_error where not all of it can be written.
void write_all(int descriptor, std::span<const std::byte> bytes);

/// Writes them, and gives their memory back as it goes. For std::uint16_t and float.
template <typename T>
void hand_over(std::vector<T> voxels, int descriptor);

/// All of a file, which is empty afterwards. By reading, not mapping: who wrote it could cut a
/// mapped one under us. Throws Error where it holds another number of voxels. For std::uint16_t and
/// float.
template <typename T>
std::vector<T> take_over(const Descriptor& file, std::size_t count);

}  // namespace cutaway::reading
