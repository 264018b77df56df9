#include "render/lenses/lens_registry.h"

namespace cutaway {

extern const LensShape kSphereLens;

std::span<const LensShape> lens_shapes() {
  static const LensShape shapes[] = {kSphereLens};
  return shapes;
}

std::map<std::string, std::string> shader_definitions(const LensShape& shape) {
  return {{"LENS_SHAPE", '"' + std::string(shape.shader) + '"'}};
}

}  // namespace cutaway
