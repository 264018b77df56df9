// Where a volume's values lie but for a few strays: what is chosen for a volume follows these.
#pragma once

#include <cstdint>

#include "volume/volume.h"

namespace cutaway {

struct UsualValues {
  ValueRange range;          ///< physical; `nothing_value` counts as a value
  std::uint64_t strays = 0;  ///< voxels outside
};

/// All values where none is a stray: a hot or a dead voxel, which lies farther from the others than
/// several times their whole range. What fills more than half a hundredth of the voxels (of those
/// that differ from the most frequent value) is none. The answer is the same on every machine.
UsualValues usual_values(const Volume& volume);

}  // namespace cutaway
