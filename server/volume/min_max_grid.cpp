#include "volume/min_max_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/check.h"
#include "volume/parallel.h"

namespace cutaway {

namespace {

/// The bricks of one slab, in stored values: rows of voxels are folded into one row of extremes,
/// which is then cut into bricks. The first step runs over contiguous memory, so it is limited by
/// its bandwidth.
template <typename T>
class SlabScan {
 public:
  SlabScan(std::span<const T> voxels, glm::ivec3 size, int brick_size)
      : voxels_(voxels), size_(size), brick_size_(brick_size), lowest_(size.x), highest_(size.x) {}

  void fold_rows(int brick_j, int brick_k) {
    std::fill(lowest_.begin(), lowest_.end(), std::numeric_limits<T>::max());
    std::fill(highest_.begin(), highest_.end(), std::numeric_limits<T>::lowest());
    for (int k = brick_k * brick_size_; k <= last_voxel(brick_k, size_.z); ++k) {
      for (int j = brick_j * brick_size_; j <= last_voxel(brick_j, size_.y); ++j) fold_row(j, k);
    }
  }

  std::pair<T, T> extremes(int brick_i) const {
    const int begin = brick_i * brick_size_;
    const int end = last_voxel(brick_i, size_.x) + 1;
    return {*std::min_element(lowest_.begin() + begin, lowest_.begin() + end),
            *std::max_element(highest_.begin() + begin, highest_.begin() + end)};
  }

 private:
  int last_voxel(int brick, int size) const {
    return std::min((brick + 1) * brick_size_, size - 1);
  }

  void fold_row(int j, int k) {
    const T* row = voxels_.data() + (std::size_t(k) * size_.y + j) * size_.x;
    for (int i = 0; i < size_.x; ++i) lowest_[i] = std::min(lowest_[i], row[i]);
    for (int i = 0; i < size_.x; ++i) highest_[i] = std::max(highest_[i], row[i]);
  }

  std::span<const T> voxels_;
  glm::ivec3 size_;
  int brick_size_;
  std::vector<T> lowest_;
  std::vector<T> highest_;
};

/// Rounded outwards, so that the bounds hold for values computed in double precision too.
float round_down(double value) {
  const auto rounded = float(value);
  return rounded <= value ? rounded
                          : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}
float round_up(double value) { return -round_down(-value); }

template <typename T>
void scan_slab(const Volume& volume, std::span<const T> voxels, int brick_k, MinMaxGrid& grid) {
  SlabScan<T> scan(voxels, volume.geometry.size_voxels, grid.brick_size);
  std::size_t brick = std::size_t(brick_k) * grid.size_bricks.y * grid.size_bricks.x;
  for (int brick_j = 0; brick_j < grid.size_bricks.y; ++brick_j) {
    scan.fold_rows(brick_j, brick_k);
    for (int brick_i = 0; brick_i < grid.size_bricks.x; ++brick_i, ++brick) {
      const auto [lowest, highest] = scan.extremes(brick_i);
      grid.minimum[brick] = round_down(lowest * volume.value_scale + volume.value_offset);
      grid.maximum[brick] = round_up(highest * volume.value_scale + volume.value_offset);
    }
  }
}

MinMaxGrid empty_grid(glm::ivec3 size_voxels, int brick_size) {
  MinMaxGrid grid;
  grid.brick_size = brick_size;
  grid.size_bricks = glm::max((size_voxels - 2) / brick_size + 1, 1);
  const std::size_t bricks =
      std::size_t(grid.size_bricks.x) * grid.size_bricks.y * grid.size_bricks.z;
  grid.minimum.resize(bricks);
  grid.maximum.resize(bricks);
  return grid;
}

}  // namespace

MinMaxGrid build_min_max_grid(const Volume& volume, int brick_size, const ProgressSink& progress,
                              const std::stop_token& stop) {
  check(brick_size >= 1, "brick_size is " + std::to_string(brick_size));
  MinMaxGrid grid = empty_grid(volume.geometry.size_voxels, brick_size);
  const auto scan = [&](int brick_k) {
    std::visit([&](const auto& voxels) { scan_slab(volume, std::span(voxels), brick_k, grid); },
               volume.voxels);
  };
  const auto report = [&](double fraction) {
    if (progress) progress(LoadStage::min_max, fraction);
  };
  run_parallel({.count = grid.size_bricks.z, .turn = scan, .progress = report}, stop);
  return grid;
}

}  // namespace cutaway
