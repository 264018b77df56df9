#include "render/lenses/lens_registry.h"

namespace cutaway {

extern const LensShape kSphereLens;

std::span<const LensShape> lens_shapes() {
  static const LensShape shapes[] = {kSphereLens};
  return shapes;
}

}  // namespace cutaway
