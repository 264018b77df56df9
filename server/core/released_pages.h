// Memory that is read for the last time, given back while the rest of it is still to be read.
#pragma once

#include <cstddef>
#include <span>

namespace cutaway {

/// Gives the whole pages within `memory` back to the system at once, whoever owns it: what is in
/// them is lost. For large buffers that are turned into others piece by piece.
void release_pages(std::span<std::byte> memory);

}  // namespace cutaway
