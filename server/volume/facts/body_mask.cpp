#include "volume/facts/body_mask.h"

#include <algorithm>
#include <cmath>

#include "volume/facts/components.h"
#include "volume/facts/couch_section.h"
#include "volume/facts/slice_filling.h"

namespace cutaway {

namespace {

constexpr glm::dvec3 kSuperior(0.0, 0.0, 1.0);

constexpr double kErosion_mm = 5.0;
constexpr double kLeastAirOfFaces = 0.05;  // less: the volume is cut within the body
constexpr double kFewestCellsDeep = 3.0;
/// A part is the body's where it is so thick; less in small animals, whose erosion is smaller, too.
constexpr double kThickPart_mm = 12.0;
constexpr double kThickShare = 0.35;     // of the largest part's
constexpr double kSmallestPart = 0.005;  // of the largest one's cells
/// Ears, noses, fingers: what is left beside the body and hangs on it.
constexpr double kAppendage_ml = 60.0;
constexpr double kAppendage_mm = 120.0;

double air_of_faces(const CellGrid& grid, const CellMask& material) {
  std::size_t air = 0;
  std::size_t all = 0;
  const auto count = [&](glm::ivec3 cell) {
    ++all;
    air += material[grid.at(cell)] == 0 ? 1 : 0;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    glm::ivec3 cell;
    for (const int end : {0, grid.size[axis] - 1}) {
      cell[axis] = end;
      for (cell[u] = 0; cell[u] < grid.size[u]; ++cell[u])
        for (cell[v] = 0; cell[v] < grid.size[v]; ++cell[v]) count(cell);
    }
  }
  return double(air) / double(all);
}

double cell_ml(const CellGrid& grid) {
  return grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z / 1000.0;
}

CellMask where(const std::vector<float>& field, double above) {
  CellMask mask(field.size());
  std::ranges::transform(field, mask.begin(), [above](float v) { return v > above ? 1 : 0; });
  return mask;
}

/// The parts of the eroded material that are thick enough to be of the body.
CellMask thick_parts(const CellGrid& grid, int along, std::vector<float> depth_mm,
                     double erosion_mm, const std::stop_token& stop) {
  const CellMask eroded = where(depth_mm, erosion_mm);
  limit_by_sides(grid, along, depth_mm);
  const Components parts = connected_components(grid.size, Connectivity::faces, eroded, stop);
  std::vector<float> thickness_mm(parts.all.size(), 0.0F);
  const auto for_cells = [&](const auto& visit) {
    for (const VoxelRun& run : parts.runs) {
      for (int x = run.begin; x < run.end; ++x) visit(run.component, grid.at({x, run.y, run.z}));
    }
  };
  for_cells([&](int part, std::size_t at) {
    thickness_mm[part] = std::max(thickness_mm[part], depth_mm[at]);
  });
  CellMask kept(eroded.size(), 0);
  if (parts.all.empty()) return kept;
  const int largest = parts.largest();
  const double thick_mm = std::min(kThickPart_mm, kThickShare * thickness_mm[largest]);
  const double cells = kSmallestPart * double(parts.all[largest].voxels);
  for_cells([&](int part, std::size_t at) {
    const bool is_body = thickness_mm[part] >= thick_mm && double(parts.all[part].voxels) >= cells;
    kept[at] = part == largest || is_body ? 1 : 0;
  });
  return kept;
}

/// What of the material lies within `reach_mm` of the core and is connected to it there.
CellMask grown(const CellGrid& grid, const CellMask& core, const CellMask& material,
               double reach_mm, const std::stop_token& stop) {
  const std::vector<float> from_core_mm = distance_to_mm(grid, core, stop);
  CellMask near(core.size());
  for (std::size_t i = 0; i < near.size(); ++i)
    near[i] = material[i] != 0 && from_core_mm[i] <= reach_mm ? 1 : 0;
  const Components parts = connected_components(grid.size, Connectivity::faces, near, stop);
  std::vector<bool> holds_core(parts.all.size(), false);
  for (const VoxelRun& run : parts.runs) {
    for (int x = run.begin; x < run.end; ++x) {
      if (core[grid.at({x, run.y, run.z})] != 0) holds_core[run.component] = true;
    }
  }
  for (const VoxelRun& run : parts.runs) {
    if (holds_core[run.component]) continue;
    for (int x = run.begin; x < run.end; ++x) near[grid.at({x, run.y, run.z})] = 0;
  }
  return near;
}

bool touches(const CellGrid& grid, const CellMask& body, glm::ivec3 cell) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      glm::ivec3 next = cell;
      next[axis] += side;
      if (next[axis] < 0 || next[axis] >= grid.size[axis]) continue;
      if (body[grid.at(next)] != 0) return true;
    }
  }
  return false;
}

CellMask rest_of(const CellMask& material, const CellMask& body) {
  CellMask rest(material.size());
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = material[i] != 0 && body[i] == 0 ? 1 : 0;
  return rest;
}

/// Gives the body the small parts that hang on it.
void take_appendages(const CellGrid& grid, const CellMask& material, CellMask& body,
                     const std::stop_token& stop) {
  const CellMask rest = rest_of(material, body);
  const Components parts = connected_components(grid.size, Connectivity::faces, rest, stop);
  std::vector<bool> hangs(parts.all.size(), false);
  for (const VoxelRun& run : parts.runs) {
    if (hangs[run.component]) continue;
    for (int x = run.begin; x < run.end; ++x) {
      if (touches(grid, body, {x, run.y, run.z})) hangs[run.component] = true;
    }
  }
  for (std::size_t i = 0; i < parts.all.size(); ++i) {
    const Component& part = parts.all[i];
    const glm::dvec3 size_mm = glm::dvec3(part.last - part.first + 1) * grid.spacing_mm;
    const double longest_mm = std::max({size_mm.x, size_mm.y, size_mm.z});
    hangs[i] = hangs[i] && double(part.voxels) * cell_ml(grid) < kAppendage_ml &&
               longest_mm < kAppendage_mm;
  }
  for (const VoxelRun& run : parts.runs) {
    if (!hangs[run.component]) continue;
    for (int x = run.begin; x < run.end; ++x) body[grid.at({x, run.y, run.z})] = 1;
  }
}

double volume_ml(const CellGrid& grid, const CellMask& mask) {
  return double(std::ranges::count_if(mask, [](std::uint8_t v) { return v != 0; })) * cell_ml(grid);
}

BoundingBox bounds_mm(const VolumeGeometry& geometry, const CellMask& mask) {
  const CellGrid grid{geometry.size_voxels, geometry.spacing_mm};
  glm::ivec3 first = grid.size;
  glm::ivec3 last(-1);
  glm::ivec3 cell;
  std::size_t at = 0;
  for (cell.z = 0; cell.z < grid.size.z; ++cell.z) {
    for (cell.y = 0; cell.y < grid.size.y; ++cell.y) {
      for (cell.x = 0; cell.x < grid.size.x; ++cell.x, ++at) {
        if (mask[at] == 0) continue;
        first = glm::min(first, cell);
        last = glm::max(last, cell);
      }
    }
  }
  first = glm::max(first - 1, glm::ivec3(0));
  last = glm::min(last + 1, grid.size - 1);
  return bounds_patient_mm(part_of(geometry, first, last));
}

BodyMask finished(const CalmGrid& calm, const CellMask& material, CellMask body,
                  const std::stop_token& stop) {
  BodyMask mask{.geometry = calm.geometry, .factor = calm.factor};
  const CellGrid grid = mask.grid();
  fill_slices(grid, nearest_axis(calm.geometry.direction_patient, kSuperior), body, stop);
  mask.removed = rest_of(material, body);
  mask.body_ml = volume_ml(grid, body);
  mask.removed_ml = volume_ml(grid, mask.removed);
  mask.body_bounds_mm = bounds_mm(calm.geometry, body);
  mask.body = std::move(body);
  return mask;
}

}  // namespace

std::optional<BodyMask> body_mask(const CalmGrid& calm, double skin, const std::stop_token& stop) {
  const CellGrid grid{calm.geometry.size_voxels, calm.geometry.spacing_mm};
  CellMask material(calm.values.size());
  std::ranges::transform(calm.values, material.begin(),
                         [skin](float v) { return v > skin ? 1 : 0; });
  if (air_of_faces(grid, material) < kLeastAirOfFaces) return std::nullopt;
  const std::vector<float> depth_mm = distance_to_mm(grid, inverted(material), stop);
  const double deepest_mm = *std::ranges::max_element(depth_mm);
  const double cell_mm = std::max({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  if (!std::isfinite(deepest_mm) || deepest_mm < kFewestCellsDeep * cell_mm) return std::nullopt;
  const double erosion_mm = std::min(kErosion_mm, 0.2 * deepest_mm);
  const int along = nearest_axis(calm.geometry.direction_patient, kSuperior);
  const CellMask core = thick_parts(grid, along, depth_mm, erosion_mm, stop);
  CellMask body = grown(grid, core, material, erosion_mm + 0.5 * cell_mm, stop);
  take_appendages(grid, material, body, stop);
  part_from_couch(grid, calm.geometry.direction_patient, material, body, stop);
  return finished(calm, material, std::move(body), stop);
}

}  // namespace cutaway
