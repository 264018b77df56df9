#include "render/lenses/lens_shape.h"

namespace cutaway {

namespace {

void set_parameters(const gl::Program& program, const Lens& lens) {
  program.set("lens_centre_mm", glm::vec3(lens.centre_mm));
  program.set("lens_radius_mm", static_cast<float>(lens.radius_mm));
}

}  // namespace

extern const LensShape kSphereLens{"sphere", "lens_sphere.glsl", set_parameters};

}  // namespace cutaway
