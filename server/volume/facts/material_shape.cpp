#include "volume/facts/material_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cutaway {

namespace {

struct MassMoments {
  double count = 0.0;
  glm::dvec3 sum{0.0};
  glm::dmat3 products{0.0};
  std::size_t on_faces = 0;
  std::size_t faces = 0;
};

bool is_on_face(glm::ivec3 cell, glm::ivec3 size) {
  for (int axis = 0; axis < 3; ++axis) {
    if (cell[axis] == 0 || cell[axis] == size[axis] - 1) return true;
  }
  return false;
}

template <typename Visit>
void for_each_cell(const CellGrid& grid, const Visit& visit) {
  std::size_t at = 0;
  glm::ivec3 cell;
  for (cell.z = 0; cell.z < grid.size.z; ++cell.z) {
    for (cell.y = 0; cell.y < grid.size.y; ++cell.y) {
      for (cell.x = 0; cell.x < grid.size.x; ++cell.x, ++at) visit(cell, at);
    }
  }
}

/// In mm along the grid's axes, from its first cell.
MassMoments moments_of(const CellGrid& grid, const CellMask& material, bool is_whole) {
  MassMoments moments;
  for_each_cell(grid, [&](glm::ivec3 cell, std::size_t at) {
    const bool on_face = is_on_face(cell, grid.size);
    moments.faces += on_face ? 1 : 0;
    if (!is_whole && material[at] == 0) return;
    moments.on_faces += on_face ? 1 : 0;
    const glm::dvec3 p = glm::dvec3(cell) * grid.spacing_mm;
    moments.count += 1.0;
    moments.sum += p;
    moments.products += glm::outerProduct(p, p);
  });
  return moments;
}

struct Eigen {
  glm::dvec3 values;
  glm::dmat3 vectors;
};

/// Jacobi's method: turns that take away one element beside the diagonal after the other.
Eigen eigen_of(glm::dmat3 a) {
  glm::dmat3 vectors(1.0);
  constexpr int kSweeps = 30;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const auto& [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
      if (a[q][p] == 0.0) continue;
      const double angle = 0.5 * std::atan2(2.0 * a[q][p], a[q][q] - a[p][p]);
      glm::dmat3 turn(1.0);
      turn[p][p] = turn[q][q] = std::cos(angle);
      turn[q][p] = std::sin(angle);
      turn[p][q] = -std::sin(angle);
      a = glm::transpose(turn) * a * turn;
      vectors = vectors * turn;
    }
  }
  return {{a[0][0], a[1][1], a[2][2]}, vectors};
}

/// Longest first.
Eigen sorted(const Eigen& eigen) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::stable_sort(order, [&](int a, int b) { return eigen.values[a] > eigen.values[b]; });
  Eigen out;
  for (int i = 0; i < 3; ++i) {
    out.values[i] = eigen.values[order[i]];
    out.vectors[i] = eigen.vectors[order[i]];
  }
  return out;
}

struct Box {
  glm::dvec3 lowest{std::numeric_limits<double>::infinity()};
  glm::dvec3 highest{-std::numeric_limits<double>::infinity()};
};

/// Along `axes`, in mm from the first cell.
Box box_of(const CellGrid& grid, const CellMask& material, bool is_whole, const glm::dmat3& axes) {
  Box box;
  const glm::dmat3 to_axes = glm::transpose(axes);
  for_each_cell(grid, [&](glm::ivec3 cell, std::size_t at) {
    if (!is_whole && material[at] == 0) return;
    const glm::dvec3 p = to_axes * (glm::dvec3(cell) * grid.spacing_mm);
    box.lowest = glm::min(box.lowest, p);
    box.highest = glm::max(box.highest, p);
  });
  return box;
}

bool is_near_an_axis(glm::dvec3 direction) {
  constexpr double kCosine = 0.9659258262890683;  // of 15 degrees
  return glm::abs(direction.x) > kCosine || glm::abs(direction.y) > kCosine ||
         glm::abs(direction.z) > kCosine;
}

}  // namespace

MaterialShape material_shape(const VolumeGeometry& geometry, const CellMask& material) {
  const CellGrid grid{geometry.size_voxels, geometry.spacing_mm};
  const bool is_empty = std::ranges::none_of(material, [](std::uint8_t v) { return v != 0; });
  const MassMoments moments = moments_of(grid, material, is_empty);
  const glm::dvec3 mean = moments.sum / moments.count;
  glm::dmat3 spread = moments.products / moments.count - glm::outerProduct(mean, mean);
  for (int axis = 0; axis < 3; ++axis)  // a cell is a box, too
    spread[axis][axis] += grid.spacing_mm[axis] * grid.spacing_mm[axis] / 12.0;
  const glm::dvec3 along_axes(spread[0][0], spread[1][1], spread[2][2]);
  Eigen eigen = sorted(eigen_of(spread));
  if (is_near_an_axis(eigen.vectors[2])) eigen = sorted({along_axes, glm::dmat3(1.0)});
  MaterialShape shape;
  const Box box = box_of(grid, material, is_empty, eigen.vectors);
  const glm::dvec3 middle = eigen.vectors * (0.5 * (box.lowest + box.highest));
  shape.centre_mm = geometry.origin_patient_mm + geometry.direction_patient * middle;
  shape.half_size_mm = 0.5 * (box.highest - box.lowest);
  shape.axes = geometry.direction_patient * eigen.vectors;
  shape.extent_mm = glm::sqrt(12.0 * glm::max(eigen.values, glm::dvec3(0.0)));
  shape.share_of_faces = double(moments.on_faces) / double(std::max<std::size_t>(moments.faces, 1));
  return shape;
}

}  // namespace cutaway
