#include "volume/pyramid.h"

#include <algorithm>
#include <cmath>

#include "volume/parallel.h"

namespace cutaway {

namespace {

/// More would span eight voxels and more, wider than a normal is asked for.
constexpr int kMostLevels = 3;
constexpr int kSmallestEdge = 8;

template <typename Stored>
Stored rounded(double mean) {
  if constexpr (std::is_integral_v<Stored>)
    return static_cast<Stored>(std::lround(mean));
  else
    return static_cast<Stored>(mean);
}

template <typename Stored>
struct Grid {
  const std::vector<Stored>& values;
  glm::ivec3 size;

  double sum_of_row(glm::ivec3 first, int count) const {
    const std::size_t row =
        (std::size_t(std::min(first.z, size.z - 1)) * size.y + std::min(first.y, size.y - 1)) *
        size.x;
    double sum = 0.0;
    for (int x = first.x; x < first.x + count; ++x) sum += values[row + std::min(x, size.x - 1)];
    return sum;
  }
};

template <typename Stored>
double mean_of(const Grid<Stored>& grid, glm::ivec3 first, glm::ivec3 count) {
  double sum = 0.0;
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y) sum += grid.sum_of_row(first + glm::ivec3(0, y, z), count.x);
  return sum / (count.x * count.y * count.z);
}

/// From the level before, whose means are of equally many voxels each.
template <typename Stored>
std::vector<Stored> coarser(const Grid<Stored>& grid, glm::ivec3 halved, glm::ivec3 size,
                            const std::stop_token& stop) {
  std::vector<Stored> means(std::size_t(size.x) * size.y * size.z);
  run_parallel({.count = size.z,
                .turn =
                    [&](int z) {
                      std::size_t at = std::size_t(z) * size.x * size.y;
                      for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x)
                          means[at++] =
                              rounded<Stored>(mean_of(grid, glm::ivec3(x, y, z) * halved, halved));
                    },
                .progress = {}},
               stop);
  return means;
}

glm::ivec3 axes_to_halve(glm::dvec3 spacing_mm) {
  const double smallest = std::min({spacing_mm.x, spacing_mm.y, spacing_mm.z});
  return {spacing_mm.x < 2.0 * smallest ? 2 : 1, spacing_mm.y < 2.0 * smallest ? 2 : 1,
          spacing_mm.z < 2.0 * smallest ? 2 : 1};
}

bool may_be_halved(glm::ivec3 size, glm::ivec3 halved) {
  for (int axis = 0; axis < 3; ++axis)
    if (halved[axis] > 1 && size[axis] < kSmallestEdge) return false;
  return true;
}

}  // namespace

std::vector<CoarseLevel> build_pyramid(const Volume& volume, const std::stop_token& stop) {
  std::vector<CoarseLevel> levels;
  glm::dvec3 spacing_mm = volume.geometry.spacing_mm;
  glm::ivec3 size = volume.geometry.size_voxels;
  glm::ivec3 factor(1);
  const Voxels* before = &volume.voxels;
  levels.reserve(kMostLevels);  // `before` points into it
  while (levels.size() < kMostLevels) {
    const glm::ivec3 halved = axes_to_halve(spacing_mm);
    if (!may_be_halved(size, halved)) break;
    const glm::ivec3 coarse = (size + halved - 1) / halved;
    Voxels voxels = std::visit(
        [&](const auto& values) -> Voxels {
          return coarser(Grid<typename std::decay_t<decltype(values)>::value_type>{values, size},
                         halved, coarse, stop);
        },
        *before);
    factor *= halved;
    levels.push_back({factor, coarse, std::move(voxels)});
    before = &levels.back().voxels;
    spacing_mm *= glm::dvec3(halved);
    size = coarse;
  }
  return levels;
}

std::size_t byte_size(const std::vector<CoarseLevel>& pyramid) {
  std::size_t sum = 0;
  for (const CoarseLevel& level : pyramid)
    sum += std::visit([](const auto& values) { return values.size() * sizeof(values[0]); },
                      level.voxels);
  return sum;
}

}  // namespace cutaway
