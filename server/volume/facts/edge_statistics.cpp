#include "volume/facts/edge_statistics.h"

#include <algorithm>
#include <cmath>

#include "volume/parallel.h"

namespace cutaway {

namespace {

constexpr int kBins = EdgeStatistics::kBins;

/// Sums of a slice: added up in the slices' order, so that every run gives the same.
struct Sums {
  EdgeStatistics::Curve cells{};
  EdgeStatistics::Curve first{};
  EdgeStatistics::Curve second{};
};

double gradient_per_mm(const CalmGrid& grid, glm::ivec3 cell) {
  double squares = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 below = cell;
    glm::ivec3 above = cell;
    below[axis] = std::max(cell[axis] - 1, 0);
    above[axis] = std::min(cell[axis] + 1, grid.geometry.size_voxels[axis] - 1);
    if (above[axis] == below[axis]) continue;
    const double apart_mm = (above[axis] - below[axis]) * grid.geometry.spacing_mm[axis];
    const double slope = (grid.values[grid.at(above)] - grid.values[grid.at(below)]) / apart_mm;
    squares += slope * slope;
  }
  return std::sqrt(squares);
}

Sums sums_of_slice(const CalmGrid& grid, const EdgeStatistics& bins, const EdgeCells& cells,
                   int z) {
  Sums sums;
  const glm::ivec3 size = grid.geometry.size_voxels;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t at = grid.at({x, y, z});
      if (!cells.inside.empty() && cells.inside[at] == 0) continue;
      const int bin = bins.bin_of(grid.values[at]);
      const double gradient = gradient_per_mm(grid, {x, y, z});
      sums.cells[bin] += 1.0;
      if (gradient < cells.least_per_mm) continue;
      sums.first[bin] += gradient;
      sums.second[bin] += gradient * gradient;
    }
  }
  return sums;
}

EdgeStatistics::Curve smoothed(const EdgeStatistics::Curve& curve) {
  EdgeStatistics::Curve out{};
  for (int i = 0; i < kBins; ++i) {
    const int first = std::max(i - 1, 0);
    const int last = std::min(i + 1, kBins - 1);
    for (int k = first; k <= last; ++k) out[i] += curve[k] / (last - first + 1);
  }
  return out;
}

void add(EdgeStatistics::Curve& to, const EdgeStatistics::Curve& curve) {
  for (int i = 0; i < kBins; ++i) to[i] += curve[i];
}

EdgeStatistics::Curve quotient(const EdgeStatistics::Curve& a, const EdgeStatistics::Curve& b) {
  EdgeStatistics::Curve out{};
  for (int i = 0; i < kBins; ++i) out[i] = b[i] > 0.0 ? a[i] / b[i] : 0.0;
  return smoothed(out);
}

}  // namespace

int EdgeStatistics::bin_of(double value) const {
  const double width = range.maximum - range.minimum;
  if (!(width > 0.0)) return 0;
  return int(std::clamp((value - range.minimum) / width * kBins, 0.0, kBins - 1.0));
}

EdgeStatistics edge_statistics(const CalmGrid& grid, const ValueRange& range,
                               const EdgeCells& cells, const std::stop_token& stop) {
  EdgeStatistics edges{.range = range};
  std::vector<Sums> slices(grid.geometry.size_voxels.z);
  const auto slice = [&](int z) { slices[z] = sums_of_slice(grid, edges, cells, z); };
  run_parallel({.count = int(slices.size()), .turn = slice, .progress = {}}, stop);
  Sums sums;
  for (const Sums& each : slices) {
    add(sums.cells, each.cells);
    add(sums.first, each.first);
    add(sums.second, each.second);
  }
  const double width = (range.maximum - range.minimum) / kBins;
  edges.cells = sums.cells;
  edges.strength_per_mm = quotient(sums.second, sums.first);
  edges.mean_gradient_per_mm = quotient(sums.first, sums.cells);
  edges.area_mm2 = smoothed(sums.first);
  for (double& area : edges.area_mm2) area *= width > 0.0 ? grid.cell_mm3() / width : 0.0;
  return edges;
}

double median_gradient_per_mm(const CalmGrid& grid) {
  constexpr std::size_t kMost = std::size_t{1} << 16;
  const std::size_t stride = std::max<std::size_t>(1, grid.values.size() / kMost) | 1;
  std::vector<double> gradients;
  for (std::size_t i = 0; i < grid.values.size(); i += stride)
    gradients.push_back(gradient_per_mm(grid, grid.cell_of(i)));
  const auto middle = gradients.begin() + std::ptrdiff_t(gradients.size() / 2);
  std::ranges::nth_element(gradients, middle);
  return *middle;
}

std::vector<int> peaks(const EdgeStatistics::Curve& curve) {
  std::vector<int> found;
  for (int i = 1, rise = 0; i < kBins; ++i) {
    if (curve[i] > curve[i - 1]) rise = i;
    const bool falls = i + 1 == kBins || curve[i + 1] < curve[i];
    if (rise > 0 && falls && curve[i] == curve[rise]) {
      if (i + 1 < kBins) found.push_back((rise + i) / 2);
      rise = 0;
    }
  }
  return found;
}

}  // namespace cutaway
