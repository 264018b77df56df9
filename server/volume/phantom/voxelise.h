// From layers of tissue to voxels of a scan.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "volume/geometry.h"
#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

inline constexpr int kStoredOffsetHu = 1024;  ///< Hounsfield units = stored - 1024
inline constexpr int kStoredLimit = 4095;     ///< 12 bits, as scanners deliver

struct VoxeliseRequest {
  VolumeGeometry geometry;  ///< axis-aligned, isotropic
  int threads = 1;
  std::function<void(double)> progress;  ///< fraction 0..1, from the calling thread
};

/// Values ramp over two to three voxels across each boundary, like the partial volumes of a scan,
/// and carry band-limited noise. The bytes do not depend on `threads`. Throws Cancelled.
std::vector<std::uint16_t> voxelise(const Layers& layers, const VoxeliseRequest& request,
                                    const std::stop_token& stop);

}  // namespace cutaway::phantom
