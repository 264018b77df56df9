#include "volume/phantom/knees_parts.h"
#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

namespace {

void add_soft_parts(Layers& layers, const ShapePtr& skin) {
  const ShapePtr muscles = meet(2, {leg_muscles(), grow(-5, skin)});
  layers.push_back({skin, {.value_hu = hu::kSkin, .blur_voxels = kSkinBlurVoxels}});
  layers.push_back(
      {skin, {.value_hu = hu::kFat, .texture_hu = 8, .texture_mm = 9, .seed = 91}, kSkinMm});
  layers.push_back(
      {muscles, {.value_hu = hu::kMuscle, .texture_hu = 14, .texture_mm = 5, .seed = 92}});
  layers.push_back({meet(0, {grow(-2, muscles), sheets(2.2f, 26, 93)}), {.value_hu = -30}});
  layers.push_back({joint_space(), {.value_hu = 22}});
  layers.push_back({meet(0, {knee_ligaments(), grow(-4, skin)}), {.value_hu = 90}});
  layers.push_back({leg_veins(), {.value_hu = 120}});
}

}  // namespace

Layers knees_layers() {
  const ShapePtr skin = leg_skin();
  Layers layers;
  add_soft_parts(layers, skin);
  layers.push_back({menisci(), {.value_hu = 105}});
  layers.push_back({knee_cartilage(), {.value_hu = hu::kCartilage}});
  const ShapePtr bones =
      meet(1, {join(0, {femur(), tibia(), fibula(), patella()}), grow(-5, skin)});
  add_bone(layers, bones, {.compact_mm = 1.7f, .seed = 94});
  const ShapePtr marrow = knee_marrow();
  layers.push_back({meet(0, {grow(5, marrow), bones}), {.value_hu = hu::kCorticalBone}});
  layers.push_back({marrow, {.value_hu = hu::kMarrow}});
  layers.push_back({grow(1.6f, bone_cyst()), {.value_hu = 900}});
  layers.push_back({bone_cyst(), {.value_hu = hu::kFluid}});
  layers.push_back({leg_arteries(), {.value_hu = hu::kContrast}});
  return layers;
}

}  // namespace cutaway::phantom
