#include "volume/facts/findings.h"

#include <algorithm>
#include <utility>

#include "core/progress.h"
#include "volume/facts/boundaries.h"
#include "volume/facts/slice_filling.h"
#include "volume/histogram.h"
#include "volume/usual_values.h"

namespace cutaway {

namespace {

constexpr double kSkinHu = -300.0;
constexpr double kBoneHu = 250.0;
constexpr double kDensestSkinHu = -100.0;    // another boundary is within the body
constexpr double kInside_mm = 10.0;          // from the body's outside
constexpr double kInsideShare = 0.25;        // of the deepest place, where that is less
constexpr double kAboveNoise = 2.5;          // times the median gradient
constexpr double kCellsAlongLongest = 64.0;  // along the longest edge
constexpr double kCouch_ml = 5.0;            // less is a speck,
constexpr double kCouchShare = 0.005;        // but in a slab or a small animal: of the body
constexpr std::size_t kMostEdgeCells = std::size_t{12} << 20;

/// Cells of at most 2 mm; fewer of them for something small would tell nothing.
double body_cell_mm(const VolumeGeometry& geometry) {
  const glm::dvec3 edges_mm = glm::dvec3(geometry.size_voxels) * geometry.spacing_mm;
  return std::min(kBodyCellMm, std::max({edges_mm.x, edges_mm.y, edges_mm.z}) / kCellsAlongLongest);
}

/// One volume on its way to its findings.
class Search {
 public:
  Search(const Volume& volume, const std::stop_token& stop) : volume_(volume), stop_(stop) {}

  Findings find() {
    const ValueTally tally = within(tally_values(volume_), usual_values(volume_).range);
    found_.robust = robust_range(tally);
    if (volume_.nothing_value) found_.robust.sentinels.push_back(*volume_.nothing_value);
    const NeighbourFacts neighbours = neighbour_facts(volume_, tally, found_.robust.range);
    found_.kind = data_kind(volume_.description, tally, found_.robust, neighbours);
    throw_if_cancelled(stop_);
    coarse_ =
        calm_grid(volume_, found_.robust, body_cell_mm(volume_.geometry), kMostBodyCells, stop_);
    choose_surfaces(tally);
    found_.shape = material_shape(coarse_.geometry, material());
    return std::move(found_);
  }

 private:
  const ValueRange& range() const { return found_.robust.range; }
  bool reaches(double value) const { return range().minimum < value && value < range().maximum; }

  void choose(ChosenValue outer, ChosenValue inner) {
    found_.outer = std::move(outer);
    found_.inner = std::move(inner);
  }
  void choose_one(double value, const char* from) { choose({value, from}, {value, from}); }

  void choose_surfaces(const ValueTally& tally) {
    const double low = tally.values.front();
    const double next = tally.values[std::min<std::size_t>(1, tally.values.size() - 1)];
    switch (found_.kind) {
      case DataKind::constant:
        return choose_one(low, "the only value");
      case DataKind::two_valued:
        return choose_one(0.5 * (low + next), "half way between the two values");
      case DataKind::labels:
        return choose_one(0.5 * (low + next), "below the lowest label");
      case DataKind::noise:
        return choose_one(tally.quantile(0.5), "noise: the middle of the values");
      case DataKind::signed_map:
        return choose({0.35 * range().maximum, "map of both signs: 0.35 of its highest"},
                      {0.65 * range().maximum, "map of both signs: 0.65 of its highest"});
      default:
        return choose_by_edges();
    }
  }

  void choose_by_edges() {
    CalmGrid fine = calm_grid(volume_, found_.robust, 0.0, kMostEdgeCells, stop_);
    smooth(fine, stop_);
    if (found_.kind == DataKind::hounsfield && reaches(kSkinHu)) {
      found_.outer = {kSkinHu, "skin of a CT"};
    } else if (const auto skin = outer_boundary(edge_statistics(
                   fine, range(), {{}, kAboveNoise * median_gradient_per_mm(fine)}, stop_))) {
      found_.outer = {*skin, "the lowest strong boundary"};
    } else {
      return choose_by_histogram();
    }
    find_body();
    choose_inner(edge_statistics(fine, range(), {inside(fine)}, stop_));
  }

  void choose_by_histogram() {
    const SuggestedSurfaces otsu = suggest_surfaces(build_histogram(volume_, 1024));
    choose({otsu.outer_iso_value, "Otsu's thresholds"},
           {otsu.inner_iso_value, "Otsu's thresholds"});
  }

  void find_body() {
    if (found_.kind != DataKind::hounsfield || found_.outer.value > kDensestSkinHu) return;
    if (auto mask = body_mask(coarse_, found_.outer.value, stop_))
      found_.body = std::make_shared<const BodyMask>(std::move(*mask));
  }

  void choose_inner(const EdgeStatistics& edges) {
    const bool is_ct = found_.kind == DataKind::hounsfield;
    if (is_ct) {
      if (const auto contrast = contrast_boundary(edges)) {
        found_.has_contrast = true;
        found_.inner = {*contrast, "contrast medium in vessels"};
        return;
      }
    }
    if (is_ct && reaches(kBoneHu)) {
      found_.inner = {kBoneHu, "bone of a CT"};
    } else if (const auto inner = inner_boundary(edges, found_.outer.value)) {
      found_.inner = {*inner, "the greatest boundary within"};
    } else {
      found_.inner = {found_.outer.value, "no boundary within: the outer one"};
    }
  }

  CellMask material() const {
    if (found_.body) return found_.body->body;
    CellMask mask(coarse_.values.size());
    std::ranges::transform(coarse_.values, mask.begin(),
                           [this](float v) { return v > found_.outer.value ? 1 : 0; });
    return mask;
  }

  /// Cells of `grid` well within the body.
  CellMask inside(const CalmGrid& grid) const {
    CellMask body = material();
    const CellGrid cells{coarse_.geometry.size_voxels, coarse_.geometry.spacing_mm};
    if (!found_.body)
      fill_slices(cells, nearest_axis(coarse_.geometry.direction_patient, {0.0, 0.0, 1.0}), body,
                  stop_);
    const std::vector<float> depth_mm = distance_to_mm(cells, inverted(body), stop_);
    float deepest_mm = 0.0F;
    for (const float depth : depth_mm) {
      if (depth < 1e30F) deepest_mm = std::max(deepest_mm, depth);
    }
    const double least_mm = std::min(kInside_mm, kInsideShare * double(deepest_mm));
    CellMask mask(grid.values.size());
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const glm::dvec3 voxel = (glm::dvec3(grid.cell_of(i)) + 0.5) * glm::dvec3(grid.factor);
      const glm::ivec3 cell = glm::min(glm::ivec3(voxel / glm::dvec3(coarse_.factor)),
                                       coarse_.geometry.size_voxels - 1);
      mask[i] = depth_mm[coarse_.at(cell)] >= least_mm ? 1 : 0;
    }
    return mask;
  }

  const Volume& volume_;
  const std::stop_token& stop_;
  Findings found_;
  CalmGrid coarse_;
};

}  // namespace

bool Findings::has_couch() const {
  return body && body->removed_ml >= std::min(kCouch_ml, kCouchShare * body->body_ml);
}

Findings find_out(const Volume& volume, const std::stop_token& stop) {
  return Search(volume, stop).find();
}

std::uint64_t byte_size(const Findings& findings) {
  return findings.body ? findings.body->body.size() + findings.body->removed.size() : 0;
}

}  // namespace cutaway
