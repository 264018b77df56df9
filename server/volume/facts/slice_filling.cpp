#include "volume/facts/slice_filling.h"

#include <array>
#include <cmath>

#include "volume/parallel.h"

namespace cutaway {

namespace {

/// One slice, as a view into the mask.
struct Slice {
  std::uint8_t* first;
  glm::ivec2 size;
  std::size_t along_u;
  std::size_t along_v;

  std::uint8_t& at(glm::ivec2 p) const { return first[p.x * along_u + p.y * along_v]; }
};

constexpr std::uint8_t kOutside = 2;

void reach(const Slice& slice, glm::ivec2 from, std::vector<glm::ivec2>& open) {
  if (slice.at(from) != 0) return;
  slice.at(from) = kOutside;
  open.push_back(from);
}

/// What the border reaches through empty cells is outside.
void fill(const Slice& slice) {
  std::vector<glm::ivec2> open;
  for (int u = 0; u < slice.size.x; ++u) {
    reach(slice, {u, 0}, open);
    reach(slice, {u, slice.size.y - 1}, open);
  }
  for (int v = 0; v < slice.size.y; ++v) {
    reach(slice, {0, v}, open);
    reach(slice, {slice.size.x - 1, v}, open);
  }
  while (!open.empty()) {
    const glm::ivec2 p = open.back();
    open.pop_back();
    if (p.x > 0) reach(slice, p - glm::ivec2(1, 0), open);
    if (p.y > 0) reach(slice, p - glm::ivec2(0, 1), open);
    if (p.x + 1 < slice.size.x) reach(slice, p + glm::ivec2(1, 0), open);
    if (p.y + 1 < slice.size.y) reach(slice, p + glm::ivec2(0, 1), open);
  }
  for (int v = 0; v < slice.size.y; ++v) {
    for (int u = 0; u < slice.size.x; ++u) {
      std::uint8_t& cell = slice.at({u, v});
      cell = cell == kOutside ? 0 : 1;
    }
  }
}

}  // namespace

void fill_slices(const CellGrid& grid, int axis, CellMask& mask, const std::stop_token& stop) {
  const std::array<std::size_t, 3> strides{1, std::size_t(grid.size.x),
                                           std::size_t(grid.size.x) * grid.size.y};
  const int u = axis == 0 ? 1 : 0;
  const int v = axis == 2 ? 1 : 2;
  const auto slice = [&](int i) {
    fill({mask.data() + i * strides[axis], {grid.size[u], grid.size[v]}, strides[u], strides[v]});
  };
  run_parallel({.count = grid.size[axis], .turn = slice, .progress = {}}, stop);
}

int nearest_axis(const glm::dmat3& axes, glm::dvec3 direction) {
  int nearest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(glm::dot(axes[axis], direction)) > std::abs(glm::dot(axes[nearest], direction)))
      nearest = axis;
  }
  return nearest;
}

}  // namespace cutaway
