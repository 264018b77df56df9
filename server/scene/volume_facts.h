// What choosing good defaults needs to know of a volume; no voxel comes with it.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/value_band.h"
#include "scene/scene.h"

namespace cutaway {

/// A thin plate of material, to be looked at from the front of it. Patient space, mm.
struct SlabView {
  glm::dvec3 centre_mm{0.0};
  glm::dmat3 half_axes_mm{1.0};          ///< columns: half the edges of a box around it
  glm::dvec3 to_viewer{0.0, -1.0, 0.0};  ///< unit, square to the plate
  glm::dvec3 up{0.0, 0.0, 1.0};
};

/// From a point in a direction (unit) to the first point where the value enters the band.
using SurfaceProbe =
    std::function<std::optional<glm::dvec3>(glm::dvec3, glm::dvec3, const ValueBand&)>;

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
  /// Where the outermost voxels' centres lie, as shares of those half axes.
  glm::dvec3 outermost_share{1.0};
  double minimum_value = 0.0;  ///< of the usual values: strays lie beyond
  double maximum_value = 0.0;
  double outer_iso_value = 0.0;  ///< context by default: skin
  double inner_iso_value = 0.0;  ///< focus by default: bone
  double window_centre = 0.0;    ///< of slices by default
  double window_width = 1.0;
  std::optional<SlabView> slab = {};
  std::string first_style;        ///< of a scene that leaves its look to the volume; "": none suits
  Preparation first_preparation;  ///< of a scene that leaves its surfaces to the volume, too
  SurfaceProbe first_surface_mm;  ///< of the volume so prepared; thread-safe
};

}  // namespace cutaway
