#include "volume/facts/components.h"

#include <algorithm>
#include <numeric>

#include "volume/parallel.h"

namespace cutaway {

namespace {

using RunsOfSlice = std::vector<VoxelRun>;

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The lower number leads, so that the answer does not depend on the order.
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

RunsOfSlice runs_of_slice(glm::ivec3 size, int z, const RowRuns& row) {
  RunsOfSlice runs;
  std::vector<glm::ivec2> of_row;
  for (int y = 0; y < size.y; ++y) {
    of_row.clear();
    row(y, z, of_row);
    for (const glm::ivec2 run : of_row) runs.push_back({run.x, run.y, y, z, 0});
  }
  return runs;
}

/// Where each row's runs begin; one more at the end.
std::vector<int> row_starts(glm::ivec3 size, const std::vector<VoxelRun>& runs) {
  std::vector<int> starts(std::size_t(size.y) * size.z + 1, 0);
  for (const VoxelRun& run : runs) ++starts[std::size_t(run.z) * size.y + run.y + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

class Joining {
 public:
  Joining(glm::ivec3 size, Connectivity connectivity, std::vector<VoxelRun>& runs)
      : size_(size),
        reach_(connectivity == Connectivity::corners ? 1 : 0),
        runs_(runs),
        starts_(row_starts(size, runs)),
        sets_(runs.size()) {}

  void join_all() {
    for (int z = 0; z < size_.z; ++z) {
      for (int y = 0; y < size_.y; ++y) {
        join(y, z, y - 1, z);
        for (int side = -reach_; side <= reach_; ++side) join(y, z, y + side, z - 1);
      }
    }
  }

  std::vector<Component> number() {
    std::vector<int> numbers(runs_.size(), -1);
    std::vector<Component> all;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      int& number = numbers[sets_.root(int(i))];
      VoxelRun& run = runs_[i];
      const glm::ivec3 first(run.begin, run.y, run.z);
      if (number < 0) {
        number = int(all.size());
        all.push_back({0, first, first});
      }
      run.component = number;
      Component& component = all[number];
      component.voxels += std::uint64_t(run.end - run.begin);
      component.first = glm::min(component.first, first);
      component.last = glm::max(component.last, glm::ivec3(run.end - 1, run.y, run.z));
    }
    return all;
  }

 private:
  void join(int y, int z, int other_y, int other_z) {
    if (other_y < 0 || other_y >= size_.y || other_z < 0) return;
    const std::size_t row = std::size_t(z) * size_.y + y;
    const std::size_t other = std::size_t(other_z) * size_.y + other_y;
    int b = starts_[other];
    for (int a = starts_[row]; a < starts_[row + 1]; ++a) {
      while (b < starts_[other + 1] && runs_[b].end + reach_ <= runs_[a].begin) ++b;
      for (int k = b; k < starts_[other + 1] && runs_[k].begin < runs_[a].end + reach_; ++k)
        sets_.join(a, k);
    }
  }

  glm::ivec3 size_;
  int reach_;
  std::vector<VoxelRun>& runs_;
  std::vector<int> starts_;
  DisjointSets sets_;
};

}  // namespace

int Components::largest() const {
  if (all.empty()) return -1;
  return int(std::ranges::max_element(all, {}, &Component::voxels) - all.begin());
}

Components connected_components(glm::ivec3 size, Connectivity connectivity, const RowRuns& row,
                                const std::stop_token& stop) {
  std::vector<RunsOfSlice> slices(size.z);
  run_parallel({.count = size.z,
                .turn = [&](int z) { slices[z] = runs_of_slice(size, z, row); },
                .progress = {}},
               stop);
  Components components;
  for (RunsOfSlice& slice : slices) {
    components.runs.insert(components.runs.end(), slice.begin(), slice.end());
    RunsOfSlice().swap(slice);
  }
  Joining joining(size, connectivity, components.runs);
  joining.join_all();
  components.all = joining.number();
  return components;
}

Components connected_components(glm::ivec3 size, Connectivity connectivity,
                                const std::vector<std::uint8_t>& mask,
                                const std::stop_token& stop) {
  const RowRuns row = [&](int y, int z, std::vector<glm::ivec2>& runs) {
    const std::uint8_t* cells = mask.data() + (std::size_t(z) * size.y + y) * size.x;
    for (int x = 0; x < size.x; ++x) {
      if (cells[x] == 0) continue;
      const int begin = x;
      while (x < size.x && cells[x] != 0) ++x;
      runs.push_back({begin, x});
    }
  };
  return connected_components(size, connectivity, row, stop);
}

}  // namespace cutaway
