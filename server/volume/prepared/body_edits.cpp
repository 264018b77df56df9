#include "volume/prepared/body_edits.h"

#include <functional>

#include "volume/parallel.h"
#include "volume/prepared/voxel_edit.h"

namespace cutaway {

namespace {

/// Of cells: the skin's ramp and the mask's stairs lie so near to its cells.
constexpr double kRim = 2.5;
constexpr double kBesideTheCouch = 1.5;
constexpr double kUnderTheSkin = 2.0;

double largest_edge_mm(const BodyMask& mask) {
  const glm::dvec3 cell = mask.geometry.spacing_mm;
  return std::max({cell.x, cell.y, cell.z});
}

/// Visits every voxel of the cells that are set, as references to stored values.
template <typename T>
void for_voxels(std::vector<T>& voxels, glm::ivec3 size, const BodyMask& mask,
                const CellMask& cells, const std::stop_token& stop,
                const std::function<void(T*, T*)>& visit) {
  const CellGrid grid = mask.grid();
  const auto slice = [&](int z) {
    for (int y = 0; y < size.y; ++y) {
      T* row = voxels.data() + (std::size_t(z) * size.y + y) * size.x;
      const std::uint8_t* of_row =
          cells.data() + grid.at({0, y / mask.factor.y, z / mask.factor.z});
      for (int cell = 0; cell < grid.size.x; ++cell) {
        if (of_row[cell] == 0) continue;
        visit(row + cell * mask.factor.x, row + std::min((cell + 1) * mask.factor.x, size.x));
      }
    }
  };
  run_parallel({.count = size.z, .turn = slice, .progress = {}}, stop);
}

/// The cells that hold neither the body nor the rim of its skin.
CellMask beside_body(const BodyMask& mask, const std::stop_token& stop) {
  const double cell_mm = largest_edge_mm(mask);
  const auto from_body_mm = distance_to_mm(mask.grid(), mask.body, stop);
  const auto from_couch_mm = distance_to_mm(mask.grid(), mask.removed, stop);
  CellMask cells(mask.body.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool is_far = from_body_mm[i] > kRim * cell_mm;
    const bool is_of_couch = from_couch_mm[i] <= kBesideTheCouch * cell_mm &&
                             from_body_mm[i] > kBesideTheCouch * cell_mm;
    cells[i] = is_far || is_of_couch || mask.removed[i] != 0 ? 1 : 0;
  }
  return cells;
}

CellMask under_skin(const BodyMask& mask, const std::stop_token& stop) {
  const auto depth_mm = distance_to_mm(mask.grid(), inverted(mask.body), stop);
  CellMask cells(mask.body.size());
  const double least_mm = kUnderTheSkin * largest_edge_mm(mask);
  std::ranges::transform(depth_mm, cells.begin(),
                         [least_mm](float depth) { return depth > least_mm ? 1 : 0; });
  return cells;
}

}  // namespace

void hide_couch(Volume& volume, const BodyMask& mask, double air, const std::stop_token& stop) {
  const CellMask cells = beside_body(mask, stop);
  std::visit(
      [&]<typename T>(std::vector<T>& voxels) {
        const T stored = stored_at_most<T>(volume, air);
        for_voxels<T>(voxels, volume.geometry.size_voxels, mask, cells, stop,
                      [stored](T* begin, T* end) { std::fill(begin, end, stored); });
      },
      volume.voxels);
}

void fill_body(Volume& volume, const BodyMask& mask, double value, const std::stop_token& stop) {
  const CellMask cells = under_skin(mask, stop);
  std::visit(
      [&]<typename T>(std::vector<T>& voxels) {
        const T stored = stored_at_most<T>(volume, value);
        for_voxels<T>(voxels, volume.geometry.size_voxels, mask, cells, stop,
                      [stored](T* begin, T* end) {
                        for (T* voxel = begin; voxel != end; ++voxel)
                          *voxel = std::max(*voxel, stored);
                      });
      },
      volume.voxels);
}

}  // namespace cutaway
