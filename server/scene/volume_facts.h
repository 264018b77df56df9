// What choosing good defaults needs to know of a volume; no voxel comes with it.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/value_band.h"

namespace cutaway {

/// Patient space, mm; physical values.
struct VolumeFacts {
  std::string id;
  glm::dvec3 bounds_minimum_mm{0.0};  ///< of the material, without the air around it
  glm::dvec3 bounds_maximum_mm{0.0};
  double diagonal_mm = 0.0;  ///< of those bounds
  glm::dvec3 grid_centre_mm{0.0};
  glm::dvec3 middle_voxel_mm{0.0};
  /// Columns: from the grid's centre to the middle of a face, along the i, j and k axes.
  glm::dmat3 grid_half_axes_mm{0.0};
  double minimum_value = 0.0;  ///< of the usual values: strays lie beyond
  double maximum_value = 0.0;
  double outer_iso_value = 0.0;  ///< context by default: skin
  double inner_iso_value = 0.0;  ///< focus by default: bone
  double window_centre = 0.0;    ///< of slices by default
  double window_width = 1.0;
  /// First point on the ray (origin, unit direction) where the value enters the band. Thread-safe.
  std::function<std::optional<glm::dvec3>(glm::dvec3, glm::dvec3, const ValueBand&)>
      first_surface_mm;
};

}  // namespace cutaway
