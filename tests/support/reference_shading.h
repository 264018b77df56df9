// The shading models again, in double.
#pragma once

#include "scene/scene.h"

namespace cutaway::reference {

/// The tone shader's stitched ramp: where in the smooth gradient, 0..1, the lookup position u
/// shows.
double tone_position(double u, double detail);

/// Display-encoded colour of a surface sample. Unit vectors in one space; `to_light` and
/// `to_viewer` point away. `light_share`: what no shadow takes of the light.
glm::dvec3 shade(const Module& shading, glm::dvec3 normal, glm::dvec3 to_light,
                 glm::dvec3 to_viewer, double light_share = 1.0);

/// The same with a soft step of the tone shader, where it asks for one: `across` and `down` are how
/// the normal changes to the next ray, `rays_a_pixel` is of the viewport's pixels.
glm::dvec3 shade_turning(const Module& shading, glm::dvec3 normal, glm::dvec3 to_light,
                         glm::dvec3 across, glm::dvec3 down, double rays_a_pixel,
                         double light_share = 1.0);

}  // namespace cutaway::reference
