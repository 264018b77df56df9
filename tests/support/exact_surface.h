// Where a ray meets an iso-surface of the trilinear field, without sampling: cell by cell, by the
// cubic that the field is along a ray within a cell. Source: S. Parker et al., "Interactive Ray
// Tracing for Isosurface Rendering", IEEE Visualization 1998.
#pragma once

#include <optional>

#include "scene/view_geometry.h"
#include "volume/volume.h"

namespace cutaway::reference {

/// Distance of the first point at which the value rises to `iso_value`, mm; the ray starts outside
/// of the grid or below the value.
std::optional<double> first_crossing_mm(const Volume& volume, const ViewRay& ray, double iso_value);

}  // namespace cutaway::reference
