// Holes of a mask, slice by slice.
#pragma once

#include "volume/facts/distance_field.h"

namespace cutaway {

/// Sets what its mask encloses within each slice square to the grid's axis `axis`.
void fill_slices(const CellGrid& grid, int axis, CellMask& mask, const std::stop_token& stop);

/// Place of the grid's axis (unit columns in patient space) that runs most along `direction`.
int nearest_axis(const glm::dmat3& axes, glm::dvec3 direction);

}  // namespace cutaway
