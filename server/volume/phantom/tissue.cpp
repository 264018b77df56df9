#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

void add_bone(Layers& layers, const ShapePtr& bone, const BoneMeasures& measures) {
  constexpr float kPeriosteumMm = 2.0f;
  layers.push_back({bone, {.value_hu = 50.0f}, -kPeriosteumMm});
  layers.push_back({bone, {.value_hu = measures.compact_hu, .blur_voxels = kBoneBlurVoxels}});
  layers.push_back({bone,
                    {.value_hu = hu::kSpongyBone,
                     .texture_hu = 85.0f,
                     .texture_mm = 4.0f,
                     .seed = measures.seed},
                    measures.compact_mm});
}

}  // namespace cutaway::phantom
