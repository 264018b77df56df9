// The patient's body in a CT, without the couch and the headrest that hold him.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "volume/facts/calm_grid.h"
#include "volume/facts/distance_field.h"

namespace cutaway {

/// Cells of a grid of at least 2 mm. Immutable.
struct BodyMask {
  VolumeGeometry geometry;  ///< of the cells' centres; patient space
  glm::ivec3 factor{1};     ///< voxels a cell
  CellMask body;            ///< filled slice by slice: lungs and bowel belong to it
  CellMask removed;         ///< denser than skin, and not the body: couch, headrest, blankets
  double body_ml = 0.0;
  double removed_ml = 0.0;
  BoundingBox body_bounds_mm;  ///< patient space, to a cell around it

  CellGrid grid() const { return {geometry.size_voxels, geometry.spacing_mm}; }
};

/// Nothing where the volume has no air around a body: cut within it, or empty. What is denser than
/// `skin` is eroded by 5 mm, so that thin plates vanish; thick parts are kept, grown back, given
/// what small parts hang on them, and parted from a couch that they lie on by the couch's section,
/// which is the same in all slices.
std::optional<BodyMask> body_mask(const CalmGrid& grid, double skin, const std::stop_token& stop);

/// Cell size that body_mask wants, mm, and how many cells at the most.
inline constexpr double kBodyCellMm = 2.0;
inline constexpr std::size_t kMostBodyCells = std::size_t{8} << 20;

}  // namespace cutaway
