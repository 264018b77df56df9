#include "volume/facts/calm_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "volume/parallel.h"

namespace cutaway {

namespace {

constexpr int kFewestCells = 8;  // along an axis; a slab of three slices keeps all

glm::ivec3 factor_for(const VolumeGeometry& geometry, double cell_mm) {
  glm::ivec3 factor(1);
  for (int axis = 0; axis < 3; ++axis) {
    const double voxels = std::round(cell_mm / geometry.spacing_mm[axis]);
    const int most = std::max(1, geometry.size_voxels[axis] / kFewestCells);
    factor[axis] = int(std::clamp(voxels, 1.0, double(most)));
  }
  return factor;
}

glm::ivec3 cells(const VolumeGeometry& geometry, glm::ivec3 factor) {
  return (geometry.size_voxels + factor - 1) / factor;
}

/// The axis along which cells are closest grows first.
glm::ivec3 grown_to(glm::ivec3 factor, const VolumeGeometry& geometry, std::size_t most_cells) {
  while (true) {
    const glm::ivec3 size = cells(geometry, factor);
    if (std::size_t(size.x) * size.y * size.z <= most_cells) return factor;
    int closest = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const auto apart = [&](int a) { return factor[a] * geometry.spacing_mm[a]; };
      if (size[axis] > 1 && (closest < 0 || apart(axis) < apart(closest))) closest = axis;
    }
    if (closest < 0) return factor;
    ++factor[closest];
  }
}

/// A stored value as the grid takes it.
struct Taken {
  double scale;
  double offset;
  ValueRange range;
  std::vector<double> sentinels;

  float operator()(double stored) const {
    const double value = stored * scale + offset;
    for (const double sentinel : sentinels) {
      if (value == sentinel) return float(range.minimum);
    }
    return float(std::clamp(value, range.minimum, range.maximum));
  }
};

template <typename T>
void mean_slice(const std::vector<T>& voxels, glm::ivec3 size, const Taken& taken, CalmGrid& grid,
                int z) {
  const glm::ivec3 of_grid = grid.geometry.size_voxels;
  const glm::ivec3 factor = grid.factor;
  std::vector<float> sums(std::size_t(of_grid.x) * of_grid.y);
  std::vector<int> counts(sums.size());
  for (int k = z * factor.z; k < std::min((z + 1) * factor.z, size.z); ++k) {
    for (int j = 0; j < size.y; ++j) {
      const T* row = voxels.data() + (std::size_t(k) * size.y + j) * size.x;
      const std::size_t cells_row = std::size_t(j / factor.y) * of_grid.x;
      for (int cell = 0, i = 0; cell < of_grid.x; ++cell) {
        const int end = std::min((cell + 1) * factor.x, size.x);
        counts[cells_row + cell] += end - i;
        for (; i < end; ++i) sums[cells_row + cell] += taken(double(row[i]));
      }
    }
  }
  float* out = grid.values.data() + std::size_t(z) * sums.size();
  for (std::size_t i = 0; i < sums.size(); ++i) out[i] = sums[i] / float(counts[i]);
}

}  // namespace

CalmGrid calm_grid(const Volume& volume, const RobustRange& robust, double cell_mm,
                   std::size_t most_cells, const std::stop_token& stop) {
  const VolumeGeometry& geometry = volume.geometry;
  CalmGrid grid;
  grid.factor = grown_to(factor_for(geometry, cell_mm), geometry, most_cells);
  grid.geometry = geometry;
  grid.geometry.size_voxels = cells(geometry, grid.factor);
  grid.geometry.spacing_mm *= glm::dvec3(grid.factor);
  grid.geometry.origin_patient_mm =
      glm::dvec3(index_to_patient(geometry) * glm::dvec4(0.5 * glm::dvec3(grid.factor - 1), 1.0));
  const glm::ivec3 size = grid.geometry.size_voxels;
  grid.values.resize(std::size_t(size.x) * size.y * size.z);
  const Taken taken{volume.value_scale, volume.value_offset, robust.range, robust.sentinels};
  const auto slice = [&](int z) {
    std::visit(
        [&](const auto& voxels) { mean_slice(voxels, geometry.size_voxels, taken, grid, z); },
        volume.voxels);
  };
  run_parallel({.count = size.z, .turn = slice, .progress = {}}, stop);
  return grid;
}

namespace {

using Kernel = std::array<float, 3>;  // middle, next, second: a Gaussian's, summing to 1 with twins

Kernel kernel_of(double deviation) {
  const double next = std::exp(-0.5 / (deviation * deviation));
  const double second = std::exp(-2.0 / (deviation * deviation));
  const double sum = 1.0 + 2.0 * (next + second);
  return {float(1.0 / sum), float(next / sum), float(second / sum)};
}

/// One line of the grid, whose neighbours are `stride` apart.
void smooth_line(float* values, int count, std::size_t stride, const Kernel& kernel,
                 std::vector<float>& line) {
  line.resize(count);
  for (int i = 0; i < count; ++i) line[i] = values[i * stride];
  const auto at = [&](int i) { return line[std::clamp(i, 0, count - 1)]; };
  for (int i = 0; i < count; ++i) {
    values[i * stride] = kernel[0] * line[i] + kernel[1] * (at(i - 1) + at(i + 1)) +
                         kernel[2] * (at(i - 2) + at(i + 2));
  }
}

void smooth_within_slice(CalmGrid& grid, int z, int axis, const Kernel& kernel) {
  const glm::ivec3 size = grid.geometry.size_voxels;
  std::vector<float> line;
  const int other = 1 - axis;
  for (int i = 0; i < size[other]; ++i) {
    const glm::ivec3 first = axis == 0 ? glm::ivec3(0, i, z) : glm::ivec3(i, 0, z);
    smooth_line(grid.values.data() + grid.at(first), size[axis], axis == 0 ? 1 : size.x, kernel,
                line);
  }
}

}  // namespace

void smooth(CalmGrid& grid, const std::stop_token& stop) {
  const glm::ivec3 size = grid.geometry.size_voxels;
  const double closest_mm = smallest_spacing_mm(grid.geometry);
  const auto kernel = [&](int axis) {
    return kernel_of(grid.geometry.spacing_mm[axis] > 2.5 * closest_mm ? 0.5 : 1.0);
  };
  const auto slice = [&](int z) {
    for (int axis = 0; axis < 2; ++axis) smooth_within_slice(grid, z, axis, kernel(axis));
  };
  run_parallel({.count = size.z, .turn = slice, .progress = {}}, stop);
  const auto along_z = [&](int y) {
    std::vector<float> line;
    for (int x = 0; x < size.x; ++x)
      smooth_line(grid.values.data() + grid.at({x, y, 0}), size.z, std::size_t(size.x) * size.y,
                  kernel(2), line);
  };
  run_parallel({.count = size.y, .turn = along_z, .progress = {}}, stop);
}

}  // namespace cutaway
