// What opaque surfaces look like beyond a normal's shade: other normals, light that is kept away,
// the cavity's wall, soft steps of a tone.
#pragma once

#include "support/reference_image.h"
#include "support/reference_layers.h"
#include "support/reference_light.h"
#include "support/reference_wall.h"

namespace cutaway::reference {

struct LookSettings {
  int supersampling = 1;
  double rays_a_pixel = 1.0;  ///< of the viewport's pixels
  Tissues tissues;
  LightRays light;
};

/// Gives each ray's surfaces the normals, and shades them, as the scene asks; translucent material
/// is left alone.
void look_again(const Scene& scene, const Volume& volume, const LookSettings& settings,
                Image<RayLayers>& rays);

}  // namespace cutaway::reference
