// How much memory there is to share out.
#pragma once

#include <cstdint>
#include <string>

namespace cutaway {

/// The machine's physical memory, or what the control groups of this process (its container, its
/// service) may have of it.
std::uint64_t machine_memory_bytes();

/// "1.5 GiB".
std::string gibibytes(std::uint64_t bytes);

}  // namespace cutaway
