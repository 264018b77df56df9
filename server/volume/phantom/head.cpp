#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

Layers head_layers() {
  const ShapePtr cranium = ellipsoid({0, 8, 42}, {73, 92, 82});
  const ShapePtr face = ellipsoid({0, -28, -30}, {56, 64, 72});
  const ShapePtr neck = rod({{{0, 22, -20}, 52}, {{0, 34, -160}, 56}});
  const ShapePtr nose = rod({{{0, -86, 10}, 6}, {{0, -108, -22}, 10}});
  const ShapePtr ear = both_sides(ellipsoid({78, 14, -4}, {5, 15, 28}));
  const ShapePtr skin = join(12, {cranium, face, neck, nose, ear});
  const ShapePtr skull = join(10, {grow(-7, cranium), ellipsoid({0, -34, -28}, {46, 46, 56})});
  const ShapePtr cavity = grow(-14, cranium);
  const ShapePtr brain = groove({5, 17, 0.25f, 3}, grow(-2, cavity));
  const ShapePtr mandible = both_sides(
      tube({{{52, 2, -14}, 6}, {{48, -6, -60}, 8}, {{24, -60, -82}, 9}, {{0, -72, -84}, 10}}));
  const ShapePtr eye = both_sides(sphere({32, -68, 10}, 12));
  return {{skin, {.value_hu = hu::kSkin}},
          {grow(-2.5f, skin), {.value_hu = hu::kFat}},
          {grow(-6, skin), {.value_hu = hu::kMuscle}},
          {join(0, {skull, mandible}), {.value_hu = hu::kCorticalBone}},
          {meet(0, {grow(-1.8f, skull), complement(grow(1.8f, cavity))}),
           {.value_hu = hu::kSpongyBone, .texture_hu = 80, .texture_mm = 4}},
          {cavity, {.value_hu = hu::kFluid}},
          {brain, {.value_hu = hu::kGreyMatter}},
          {grow(-4, brain), {.value_hu = hu::kWhiteMatter}},
          {grow(5, eye), {.value_hu = hu::kFat}},
          {eye, {.value_hu = hu::kFluid}},
          {both_sides(ellipsoid({16, -52, -18}, {10, 14, 14})), {.value_hu = hu::kAir}}};
}

}  // namespace cutaway::phantom
