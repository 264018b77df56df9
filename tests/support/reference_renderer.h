// A plain ray caster on the CPU, in double precision: slow and obvious, the measure of the GPU's
// pictures. It shares the sampling rule with the renderer (samples at whole steps from the box's
// entry, and at both ends of each stretch), not its code.
#pragma once

#include "scene/scene.h"
#include "support/reference_image.h"
#include "volume/volume.h"

namespace cutaway::reference {

struct Settings {
  glm::ivec2 picture_size_px{0};
  double resolution_scale = 1.0;
  int supersampling = 1;
  double step_voxels = 1.0;
};

enum class Label { background, context, focus };

struct SurfaceSample {
  Label label = Label::background;
  double distance_mm = 0.0;
  glm::dvec3 normal{0.0};         ///< patient space, towards the viewer
  bool lens_was_crossed = false;  ///< the ray went through the lens before it ended
};

struct Result {
  Image<SurfaceSample> surface;  ///< one sample a ray
  ColourImage picture;
};

Result render(const Scene& scene, const Volume& volume, const Settings& settings);

}  // namespace cutaway::reference
