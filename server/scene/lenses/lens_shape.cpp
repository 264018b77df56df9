#include "scene/lenses/lens_shape.h"

#include <algorithm>
#include <string>

#include "core/check.h"

namespace cutaway {

std::span<const LensShape> lens_shapes() {
  static const LensShape shapes[] = {{"sphere", &kUnitBall},
                                     {"ellipsoid", &kUnitBall},
                                     {"box", &kUnitBox},
                                     {"cylinder", &kUnitCylinder},
                                     {"cone", &kUnitCone}};
  return shapes;
}

const LensShape& find_lens_shape(std::string_view name) {
  const auto shapes = lens_shapes();
  const auto shape = std::ranges::find(shapes, name, &LensShape::name);
  check(shape != shapes.end(), "no lens shape " + std::string(name));
  return *shape;
}

}  // namespace cutaway
