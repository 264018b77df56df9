#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

Layers abdomen_layers() {
  const ShapePtr skin =
      tube({{{0, 0, 260}, 110}, {{0, 0, 0}, 108}, {{0, 0, -260}, 118}}, {0.7f, 1, 1});
  const ShapePtr spine = rod({{{0, 45, 260}, 22}, {{0, 45, -110}, 24}});
  return {{skin, {.value_hu = hu::kSkin}},
          {grow(-3, skin), {.value_hu = hu::kFat}},
          {grow(-18, skin), {.value_hu = hu::kMuscle}},
          {grow(-30, skin), {.value_hu = hu::kFat}},
          {ellipsoid({-60, -10, 120}, {80, 65, 60}), {.value_hu = 105}},
          {ellipsoid({95, 30, 120}, {28, 40, 50}), {.value_hu = 115}},
          {both_sides(ellipsoid({60, 40, 40}, {26, 22, 52})), {.value_hu = 160}},
          {spine, {.value_hu = hu::kCorticalBone}},
          {grow(-2, spine), {.value_hu = hu::kSpongyBone}},
          {rod({{{0, 10, 260}, 11}, {{0, 10, -20}, 9}}), {.value_hu = hu::kContrast}}};
}

}  // namespace cutaway::phantom
