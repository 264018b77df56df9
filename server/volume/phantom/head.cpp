#include "volume/phantom/head_parts.h"
#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

namespace {

Layers outer_layers(const ShapePtr& skin) {
  const ShapePtr muscles = meet(1, {head_muscles(), grow(-3.5f, skin)});
  return {{skin, {.value_hu = hu::kSkin, .blur_voxels = kSkinBlurVoxels}},
          {skin, {.value_hu = hu::kFat, .texture_hu = 8, .texture_mm = 9, .seed = 21}, kSkinMm},
          {muscles, {.value_hu = hu::kMuscle, .texture_hu = 14, .texture_mm = 5, .seed = 22}},
          {meet(0, {grow(-2, muscles), sheets(2.2f, 24, 23)}), {.value_hu = -30}}};
}

void add_brain(Layers& layers) {
  const ShapePtr brain = cerebrum();
  const ShapePtr small_brain = cerebellum();
  layers.push_back({cranial_cavity(), {.value_hu = hu::kFluid}});
  layers.push_back({brain, {.value_hu = hu::kGreyMatter}});
  layers.push_back({brain, {.value_hu = hu::kWhiteMatter}, 3.5f});
  layers.push_back({small_brain, {.value_hu = hu::kGreyMatter}});
  layers.push_back({small_brain, {.value_hu = hu::kWhiteMatter}, 4});
  layers.push_back({spinal_canal(), {.value_hu = hu::kFluid}});
  layers.push_back({brainstem(), {.value_hu = hu::kWhiteMatter + 5}});
  layers.push_back({ventricles(), {.value_hu = hu::kFluid - 3}});
}

void add_eyes(Layers& layers, const ShapePtr& skin) {
  layers.push_back({meet(1, {orbits(), grow(-3, skin)}), {.value_hu = hu::kFat}});
  layers.push_back({orbital_muscles(), {.value_hu = hu::kMuscle}});
  const ShapePtr eyes = eyeballs();
  layers.push_back({eyes, {.value_hu = 65}});
  layers.push_back({eyes, {.value_hu = hu::kFluid}, 1.3f});
  layers.push_back({eye_lenses(), {.value_hu = 95}});
}

}  // namespace

Layers head_layers() {
  const ShapePtr skin = head_skin();
  const ShapePtr below_skin = grow(-4, skin);
  Layers layers = outer_layers(skin);
  layers.push_back({larynx_cartilage(), {.value_hu = hu::kCartilage}});
  add_bone(layers, meet(1, {join(0, {skull(), cervical_spine(), hyoid()}), below_skin}),
           {.seed = 31});
  add_bone(layers, meet(1, {mandible(), below_skin}), {.seed = 32});
  layers.push_back({tooth_roots(), {.value_hu = hu::kCorticalBone + 250}});
  layers.push_back({tooth_crowns(), {.value_hu = hu::kEnamel}});
  add_brain(layers);
  add_eyes(layers, skin);
  layers.push_back({head_veins(), {.value_hu = 150}});
  layers.push_back({meet(1, {head_arteries(), grow(-2.5f, skin)}), {.value_hu = hu::kContrast}});
  layers.push_back({join(1, {sinuses(), nasal_cavity(), nostrils(), throat(), ear_canals()}), {}});
  layers.push_back({nasal_walls(), {.value_hu = hu::kSkin}});
  layers.push_back({earring(), {.value_hu = 2900}});
  return layers;
}

}  // namespace cutaway::phantom
