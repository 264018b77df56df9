// A plain ray caster on the CPU, in double precision: slow and obvious, the measure of the GPU's
// pictures. It shares the sampling rule with the renderer (samples at whole steps from the box's
// entry, and at both ends of each stretch), not its code.
#pragma once

#include "scene/scene.h"
#include "support/reference_image.h"
#include "support/reference_layers.h"
#include "support/reference_looks.h"
#include "volume/volume.h"

namespace cutaway::reference {

struct Settings {
  glm::ivec2 picture_size_px{0};
  double resolution_scale = 1.0;
  int supersampling = 1;
  double step_voxels = 1.0;
  Tissues tissues = {};
  LightRays light = {};
};

struct Result {
  Image<RayLayers> rays;
  ColourImage picture;
};

Result render(const Scene& scene, const Volume& volume, const Settings& settings);

}  // namespace cutaway::reference
