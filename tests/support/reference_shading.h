// The shading models again, in double.
#pragma once

#include "scene/scene.h"

namespace cutaway::reference {

/// The tone shader's stitched ramp: where in the smooth gradient, 0..1, the lookup position u
/// shows.
double tone_position(double u, double detail);

/// Display-encoded colour of a surface sample. Unit vectors in one space; `to_light` and
/// `to_viewer` point away.
glm::dvec3 shade(const Module& shading, glm::dvec3 normal, glm::dvec3 to_light,
                 glm::dvec3 to_viewer);

}  // namespace cutaway::reference
