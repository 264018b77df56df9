#include "volume/prepared/islands.h"

#include "volume/facts/components.h"
#include "volume/prepared/voxel_edit.h"

namespace cutaway {

namespace {

constexpr double kMm3PerMl = 1000.0;

template <typename T>
void drop(std::vector<T>& voxels, T highest_outside, glm::ivec3 size, double fewest_voxels,
          const std::stop_token& stop) {
  const auto row_of = [&](int y, int z) {
    return voxels.data() + (std::size_t(z) * size.y + y) * size.x;
  };
  const RowRuns runs_of_row = [&](int y, int z, std::vector<glm::ivec2>& runs) {
    const T* row = row_of(y, z);
    for (int x = 0; x < size.x; ++x) {
      if (!(row[x] > highest_outside)) continue;
      const int begin = x;
      while (x < size.x && row[x] > highest_outside) ++x;
      runs.push_back({begin, x});
    }
  };
  const Components parts = connected_components(size, Connectivity::corners, runs_of_row, stop);
  const auto is_small = [&](int part) { return double(parts.all[part].voxels) < fewest_voxels; };
  if (parts.all.empty() || is_small(parts.largest())) return;
  for (const VoxelRun& run : parts.runs) {
    if (is_small(run.component))
      std::fill(row_of(run.y, run.z) + run.begin, row_of(run.y, run.z) + run.end, highest_outside);
  }
}

}  // namespace

void drop_islands(Volume& volume, const IslandLimit& limit, const std::stop_token& stop) {
  if (limit.band.has_upper_end()) return;
  const glm::dvec3 spacing = volume.geometry.spacing_mm;
  const double fewest_voxels = limit.smallest_ml * kMm3PerMl / (spacing.x * spacing.y * spacing.z);
  std::visit(
      [&]<typename T>(std::vector<T>& voxels) {
        drop<T>(voxels, stored_at_most<T>(volume, limit.band.lower), volume.geometry.size_voxels,
                fewest_voxels, stop);
      },
      volume.voxels);
}

}  // namespace cutaway
