// A couch that the body lies on: its section is the same all along the patient.
#pragma once

#include <stop_token>

#include "volume/facts/distance_field.h"

namespace cutaway {

/// Takes from `body` what belongs to a couch that touches it. Where the material beside the body
/// holds a plate that runs through most slices, its section (seen in a good share of the slices
/// where the body does not cover it, and drawn through under the body from both sides) is no body
/// in any slice. `axes`: the grid's, unit columns in patient space.
void part_from_couch(const CellGrid& grid, const glm::dmat3& axes, const CellMask& material,
                     CellMask& body, const std::stop_token& stop);

}  // namespace cutaway
