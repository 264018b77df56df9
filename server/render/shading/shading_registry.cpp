#include "render/shading/shading_registry.h"

namespace cutaway {

extern const ShadingModel kToneShading;
extern const ShadingModel kPhongShading;

std::span<const ShadingModel> shading_models() {
  static const ShadingModel models[] = {kToneShading, kPhongShading};
  return models;
}

}  // namespace cutaway
