// What another renderer needs to do the same work as a case of the benchmark:
// tests/benchmark/yardstick.py.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.h"
#include "volume/volume.h"

namespace cutaway::benchmark {

/// Pixels where the context's surface was hit, 255 there and 0 elsewhere; rows top first.
struct Silhouette {
  Viewport size;
  std::vector<std::uint8_t> pixels;
};

/// Writes `task.json` (grid, camera, iso-value and step, all in patient space and millimetres),
/// `voxels.raw` (physical values in little-endian shorts, i fastest) and `silhouette.raw` into the
/// folder, which is made. Throws Error where a value fits no short or the folder cannot be written.
void write_yardstick_task(const std::filesystem::path& folder, const Volume& volume,
                          const Scene& scene, const Silhouette& silhouette);

}  // namespace cutaway::benchmark
