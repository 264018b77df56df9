#include "volume/facts/distance_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "volume/parallel.h"

namespace cutaway {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Lower envelope of the parabolas over one line of squared distances.
class Line {
 public:
  Line(int count, double spacing_mm)
      : squared_mm2_(spacing_mm * spacing_mm), f_(count), at_(count), from_(count + 1) {}

  void transform(float* values, std::size_t stride) {
    const int count = int(f_.size());
    for (int i = 0; i < count; ++i) f_[i] = values[i * stride];
    const int parabolas = envelope(count);
    for (int i = 0, k = 0; i < count; ++i) {
      if (parabolas == 0) break;
      while (k + 1 < parabolas && from_[k + 1] < i) ++k;
      const double apart = i - at_[k];
      values[i * stride] = float(apart * apart * squared_mm2_ + f_[at_[k]]);
    }
  }

 private:
  /// Where the parabola at `b` goes below the one at `a`.
  double crossing(int a, int b) const {
    return ((f_[b] - f_[a]) / squared_mm2_ + double(b) * b - double(a) * a) / (2.0 * (b - a));
  }

  int envelope(int count) {
    int k = 0;
    for (int i = 0; i < count; ++i) {
      if (f_[i] == kFar) continue;
      double from = -double(count);
      while (k > 0 && (from = crossing(at_[k - 1], i)) <= from_[k - 1]) --k;
      if (k == 0) from = -double(count);
      at_[k] = i;
      from_[k] = from;
      ++k;
    }
    return k;
  }

  double squared_mm2_;
  std::vector<double> f_;
  std::vector<int> at_;
  std::vector<double> from_;
};

}  // namespace

std::vector<float> distance_to_mm(const CellGrid& grid, const CellMask& mask,
                                  const std::stop_token& stop) {
  std::vector<float> field(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) field[i] = mask[i] != 0 ? 0.0F : kFar;
  const glm::ivec3 size = grid.size;
  const auto slice = [&](int z) {
    Line along_x(size.x, grid.spacing_mm.x);
    for (int y = 0; y < size.y; ++y) along_x.transform(field.data() + grid.at({0, y, z}), 1);
    Line along_y(size.y, grid.spacing_mm.y);
    for (int x = 0; x < size.x; ++x)
      along_y.transform(field.data() + grid.at({x, 0, z}), std::size_t(size.x));
  };
  run_parallel({.count = size.z, .turn = slice, .progress = {}}, stop);
  const auto columns = [&](int y) {
    Line along_z(size.z, grid.spacing_mm.z);
    for (int x = 0; x < size.x; ++x)
      along_z.transform(field.data() + grid.at({x, y, 0}), std::size_t(size.x) * size.y);
  };
  run_parallel({.count = size.y, .turn = columns, .progress = {}}, stop);
  for (float& squared : field) squared = std::sqrt(squared);
  return field;
}

void limit_by_sides(const CellGrid& grid, int along, std::vector<float>& depth_mm) {
  for (std::size_t i = 0; i < depth_mm.size(); ++i) {
    const glm::ivec3 cell(int(i % grid.size.x), int(i / grid.size.x % grid.size.y),
                          int(i / grid.size.x / grid.size.y));
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == along) continue;
      const int cells = std::min(cell[axis], grid.size[axis] - 1 - cell[axis]);
      depth_mm[i] = std::min(depth_mm[i], float((cells + 0.5) * grid.spacing_mm[axis]));
    }
  }
}

CellMask inverted(const CellMask& mask) {
  CellMask out(mask.size());
  std::ranges::transform(mask, out.begin(), [](std::uint8_t v) { return v == 0 ? 1 : 0; });
  return out;
}

}  // namespace cutaway
