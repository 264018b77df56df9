#include "volume/facts/couch_section.h"

#include <algorithm>
#include <optional>

#include "volume/facts/components.h"
#include "volume/facts/slice_filling.h"

namespace cutaway {

namespace {

constexpr double kPlate_mm = 13.0;    // half the thickness of the thickest couch
constexpr double kPlateShare = 0.35;  // of the body's, in small animals
constexpr double kMostSlices = 0.6;   // that a couch runs through
constexpr double kSeenSlices = 0.5;   // in which a place of its section is seen
constexpr double kSameSection = 0.6;  // of the places of its section
constexpr double kFewestColumns = 4.0;
constexpr int kBackSlack = 2;  // cells: a couch is at the body's back

/// The grid's axes as the couch has them: across, from front to back, along the patient.
struct CouchAxes {
  int across;
  int back;
  int along;
  bool is_back_first;  ///< the grid's axis runs from back to front

  explicit CouchAxes(const glm::dmat3& axes)
      : back(nearest_axis(axes, {0.0, 1.0, 0.0})), along(nearest_axis(axes, {0.0, 0.0, 1.0})) {
    if (back == along) back = (along + 1) % 3;
    across = 3 - back - along;
    is_back_first = axes[back].y < 0.0;
  }
};

/// Per place (across, back) of a section: in how many slices it is set.
class Section {
 public:
  Section(const CellGrid& grid, const CouchAxes& axes)
      : grid_(grid), axes_(axes), counts_(std::size_t(width()) * height(), 0) {}

  int width() const { return grid_.size[axes_.across]; }
  int height() const { return grid_.size[axes_.back]; }
  int slices() const { return grid_.size[axes_.along]; }

  /// `depth` counts from the front.
  std::size_t at(int column, int depth) const { return std::size_t(depth) * width() + column; }
  glm::ivec3 cell(int column, int depth, int slice) const {
    glm::ivec3 cell;
    cell[axes_.across] = column;
    cell[axes_.back] = axes_.is_back_first ? height() - 1 - depth : depth;
    cell[axes_.along] = slice;
    return cell;
  }
  std::size_t place(glm::ivec3 cell) const {
    const int depth = axes_.is_back_first ? height() - 1 - cell[axes_.back] : cell[axes_.back];
    return at(cell[axes_.across], depth);
  }
  std::vector<int>& counts() { return counts_; }

  Section empty_copy() const { return Section(grid_, axes_); }
  /// -1 where nothing is set.
  int hindmost_set() const {
    for (std::size_t i = counts_.size(); i > 0; --i) {
      if (counts_[i - 1] > 0) return int((i - 1) / width());
    }
    return -1;
  }
  void add(const CellMask& mask) {
    for (int slice = 0; slice < slices(); ++slice) {
      for (int depth = 0; depth < height(); ++depth) {
        for (int column = 0; column < width(); ++column)
          counts_[at(column, depth)] += mask[grid_.at(cell(column, depth, slice))];
      }
    }
  }

 private:
  CellGrid grid_;
  CouchAxes axes_;
  std::vector<int> counts_;
};

/// What of the material a ball of half the thickness of a couch does not reach into.
CellMask thin_parts(const CellGrid& grid, int along, const CellMask& material,
                    const std::stop_token& stop) {
  std::vector<float> depth_mm = distance_to_mm(grid, inverted(material), stop);
  limit_by_sides(grid, along, depth_mm);
  const double deepest_mm = *std::ranges::max_element(depth_mm);
  const double plate_mm = std::min(kPlate_mm, kPlateShare * deepest_mm);
  CellMask core(material.size());
  std::ranges::transform(depth_mm, core.begin(),
                         [plate_mm](float d) { return d > plate_mm ? 1 : 0; });
  const std::vector<float> from_core_mm = distance_to_mm(grid, core, stop);
  const double reach_mm =
      plate_mm + std::max({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  CellMask thin(material.size());
  for (std::size_t i = 0; i < thin.size(); ++i)
    thin[i] = material[i] != 0 && !(from_core_mm[i] <= reach_mm) ? 1 : 0;
  return thin;
}

/// Adds a part's section where the part runs through most slices and is the same in them.
void add_if_couch(const Components& parts, int part, int along, int body_back, Section& of_couch) {
  const Component& box = parts.all[part];
  const int run_slices = box.last[along] - box.first[along] + 1;
  if (run_slices < kMostSlices * of_couch.slices()) return;
  Section of_part = of_couch.empty_copy();
  for (const VoxelRun& run : parts.runs) {
    if (run.component != part) continue;
    for (int x = run.begin; x < run.end; ++x) ++of_part.counts()[of_part.place({x, run.y, run.z})];
  }
  double seen = 0.0;
  double same = 0.0;
  for (const int count : of_part.counts()) {
    seen += count > 0 ? 1.0 : 0.0;
    same += count >= kSeenSlices * run_slices ? 1.0 : 0.0;
  }
  if (same < kSameSection * seen || same < kFewestColumns) return;
  if (of_part.hindmost_set() < body_back - kBackSlack) return;
  for (std::size_t i = 0; i < of_part.counts().size(); ++i) {
    if (of_part.counts()[i] >= kSeenSlices * run_slices) of_couch.counts()[i] = 1;
  }
}

/// From `first` to `last` from the front.
struct Span {
  int first = 0;
  int last = -1;
};

std::vector<std::optional<Span>> spans_of(Section& couch) {
  std::vector<std::optional<Span>> spans(couch.width());
  for (int column = 0; column < couch.width(); ++column) {
    for (int depth = 0; depth < couch.height(); ++depth) {
      if (couch.counts()[couch.at(column, depth)] == 0) continue;
      if (!spans[column]) spans[column] = Span{depth, depth};
      spans[column]->last = depth;
    }
  }
  return spans;
}

/// Depth of the hindmost material of a column, in the slice in the middle of all.
int hindmost(const CellGrid& grid, const CellMask& material, const Section& section, int column) {
  std::vector<int> depths;
  for (int slice = 0; slice < section.slices(); ++slice) {
    int depth = section.height() - 1;
    while (depth >= 0 && material[grid.at(section.cell(column, depth, slice))] == 0) --depth;
    depths.push_back(depth);
  }
  std::ranges::nth_element(depths, depths.begin() + std::ptrdiff_t(depths.size() / 2));
  return depths[depths.size() / 2];
}

/// Under the body, between the couch's sides, its section is as thick as they are.
void draw_through(const CellGrid& grid, const CellMask& material, Section& couch) {
  const auto spans = spans_of(couch);
  std::vector<int> thickness;
  std::vector<int> columns;
  for (int column = 0; column < couch.width(); ++column) {
    if (!spans[column]) continue;
    columns.push_back(column);
    thickness.push_back(spans[column]->last - spans[column]->first + 1);
  }
  if (columns.empty()) return;
  std::ranges::nth_element(thickness, thickness.begin() + std::ptrdiff_t(thickness.size() / 2));
  const int thick = thickness[thickness.size() / 2];
  for (int column = columns.front(); column <= columns.back(); ++column) {
    if (spans[column] && spans[column]->last - spans[column]->first + 1 >= thick) continue;
    const int last = hindmost(grid, material, couch, column);
    for (int depth = std::max(0, last - thick + 1); depth <= last; ++depth)
      couch.counts()[couch.at(column, depth)] = 1;
  }
}

}  // namespace

void part_from_couch(const CellGrid& grid, const glm::dmat3& axes, const CellMask& material,
                     CellMask& body, const std::stop_token& stop) {
  const CouchAxes of_couch(axes);
  Section couch(grid, of_couch);
  const Components parts = connected_components(
      grid.size, Connectivity::faces, thin_parts(grid, of_couch.along, material, stop), stop);
  Section of_body = couch.empty_copy();
  of_body.add(body);
  for (std::size_t part = 0; part < parts.all.size(); ++part)
    add_if_couch(parts, int(part), of_couch.along, of_body.hindmost_set(), couch);
  draw_through(grid, material, couch);
  for (int depth = 0; depth < couch.height(); ++depth) {
    for (int column = 0; column < couch.width(); ++column) {
      if (couch.counts()[couch.at(column, depth)] == 0) continue;
      for (int slice = 0; slice < couch.slices(); ++slice) {
        const std::size_t at = grid.at(couch.cell(column, depth, slice));
        if (material[at] != 0) body[at] = 0;
      }
    }
  }
}

}  // namespace cutaway
