// How a slice's plane lies in its picture: the one place that says which side is left.
#pragma once

#include "scene/scene.h"

namespace cutaway {

/// The orthographic camera whose eye lies on the slice's plane and looks along its normal, so that
/// a ray of view_geometry.h starts at the point that its pixel shows. `scene.viewport.kind` says
/// which slice, and is not the volume; the grid's half axes as in VolumeFacts.
Camera slice_camera(const Scene& scene, const glm::dmat3& grid_half_axes_mm);

/// Whether a viewport shows the same picture of both scenes, which are of one volume. What a slice
/// does not depend on costs it no frame, nor do slices the 3-D picture.
bool show_the_same(const Scene& a, const Scene& b);

}  // namespace cutaway
