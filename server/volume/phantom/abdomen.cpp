#include "volume/phantom/abdomen_parts.h"
#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

namespace {

constexpr float kStoolHu = 25.0f;
constexpr float kBowelGasHu = -880.0f;
constexpr float kLungHu = -840.0f;

void add_wall(Layers& layers) {
  const ShapePtr skin = abdomen_skin();
  const ShapePtr muscles = meet(2, {abdomen_muscles(), grow(-7, skin)});
  const Tissue muscle{.value_hu = hu::kMuscle, .texture_hu = 14, .texture_mm = 6, .seed = 52};
  layers.push_back({skin, {.value_hu = hu::kSkin, .blur_voxels = kSkinBlurVoxels}});
  layers.push_back({skin,
                    {.value_hu = hu::kFat, .texture_hu = 8, .texture_mm = 10, .seed = 51},
                    1.25f * kSkinMm});
  layers.push_back({muscles, muscle});
  layers.push_back({meet(0, {grow(-3, muscles), sheets(3, 40, 53)}), {.value_hu = -30}});
  layers.push_back(
      {abdomen_cavity(), {.value_hu = hu::kFat, .texture_hu = 10, .texture_mm = 12, .seed = 54}});
  layers.push_back({deep_muscles(), muscle});
}

/// Wall, contents, and gas that has risen to the front of a body lying on its back.
void add_bowel(Layers& layers, const ShapePtr& bowel, float wall_mm, float gas_level_y_mm,
               std::uint32_t seed) {
  const ShapePtr level = half_space({0, gas_level_y_mm, 0}, {0, 1, 0});
  layers.push_back({bowel, {.value_hu = 75}});
  layers.push_back(
      {bowel, {.value_hu = kStoolHu, .texture_hu = 25, .texture_mm = 7, .seed = seed}, wall_mm});
  layers.push_back({meet(1, {grow(-wall_mm, bowel), roughen({14, 40, seed}, level)}),
                    {.value_hu = kBowelGasHu}});
}

void add_organs(Layers& layers) {
  const ShapePtr both_kidneys = kidneys();
  const ShapePtr urine = bladder();
  layers.push_back({liver(), {.value_hu = 108, .texture_hu = 6, .texture_mm = 8, .seed = 61}});
  layers.push_back({gallbladder(), {.value_hu = hu::kFluid}});
  layers.push_back({spleen(), {.value_hu = 122, .texture_hu = 6, .texture_mm = 7, .seed = 62}});
  layers.push_back({pancreas(), {.value_hu = 92, .texture_hu = 10, .texture_mm = 5, .seed = 63}});
  layers.push_back({both_kidneys, {.value_hu = 185}});
  layers.push_back(
      {both_kidneys, {.value_hu = 135, .texture_hu = 45, .texture_mm = 16, .seed = 64}, 8});
  layers.push_back({kidney_pelves(), {.value_hu = hu::kFluid}});
  layers.push_back({urine, {.value_hu = hu::kMuscle}});
  layers.push_back({urine, {.value_hu = hu::kFluid}, 3.5f});
}

void add_bones(Layers& layers) {
  const ShapePtr bones =
      meet(1, {join(0, {lumbar_spine(), sacrum(), pelvis(), ribs()}), grow(-6, abdomen_skin())});
  layers.push_back({rib_cartilage(), {.value_hu = hu::kCartilage}});
  layers.push_back({discs(), {.value_hu = 85}});
  add_bone(layers, bones, {.compact_mm = 2.2f, .compact_hu = hu::kCorticalBone - 200, .seed = 71});
  add_bone(layers, thigh_bones(), {.compact_mm = 2.2f, .seed = 72});
  layers.push_back({grow(3, thigh_marrow()), {.value_hu = hu::kCorticalBone}});
  layers.push_back({thigh_marrow(), {.value_hu = hu::kMarrow}});
  layers.push_back({rod({{{0, 66, 280}, 8},
                         {{0, 62, 120}, 8},
                         {{0, 55, 30}, 8.5f},
                         {{0, 62, -40}, 8},
                         {{0, 74, -70}, 8}}),
                    {.value_hu = 30}});
}

}  // namespace

Layers abdomen_layers() {
  Layers layers;
  add_wall(layers);
  layers.push_back({diaphragm_dome(), {.value_hu = hu::kFat}});
  layers.push_back(
      {lung_bases(), {.value_hu = kLungHu, .texture_hu = 40, .texture_mm = 5, .seed = 55}});
  layers.push_back({heart(), {.value_hu = 150}});
  add_bowel(layers, small_bowel(), 2.6f, -64, 81);
  add_bowel(layers, colon(), 3, -12, 82);
  add_bowel(layers, stomach(), 3.6f, -44, 83);
  add_organs(layers);
  layers.push_back({abdomen_veins(), {.value_hu = 140}});
  layers.push_back({portal_vein(), {.value_hu = 165}});
  add_bones(layers);
  layers.push_back({abdomen_arteries(), {.value_hu = hu::kContrast}});
  return layers;
}

}  // namespace cutaway::phantom
