// How what there is to see lies in the volume: from where it is seen best.
#pragma once

#include "volume/facts/calm_grid.h"
#include "volume/facts/distance_field.h"

namespace cutaway {

/// Patient space, mm.
struct MaterialShape {
  glm::dvec3 centre_mm{0.0};     ///< of the box around it along these axes
  glm::dmat3 axes{1.0};          ///< unit columns, longest extent first
  glm::dvec3 half_size_mm{0.0};  ///< of that box, along them
  glm::dvec3 extent_mm{0.0};     ///< of a box with the same second moments
  double share_of_faces = 0.0;   ///< of the volume's outermost cells, that hold some

  /// A thin plate: its shortest extent is less than 0.35 of the second.
  bool is_slab() const { return extent_mm.z < 0.35 * extent_mm.y; }
};

/// Of a mask's cells; of the whole grid where it is empty. Axes within 15 degrees of the grid's are
/// the grid's.
MaterialShape material_shape(const VolumeGeometry& geometry, const CellMask& material);

}  // namespace cutaway
