#include "volume/phantom/tissue.h"

namespace cutaway::phantom {

Layers knees_layers() {
  const ShapePtr leg =
      both_sides(tube({{{70, 0, 200}, 66}, {{70, 0, 0}, 56}, {{70, 4, -200}, 54}}));
  const ShapePtr femur = both_sides(join(14, {rod({{{70, -6, 200}, 14}, {{70, 0, 40}, 17}}),
                                              sphere({48, 6, 22}, 21), sphere({92, 6, 22}, 21)}));
  const ShapePtr tibia = both_sides(join(12, {rod({{{70, -4, -200}, 13}, {{70, 2, -40}, 19}}),
                                              ellipsoid({70, 4, -18}, {38, 24, 15})}));
  const ShapePtr fibula = both_sides(rod({{{108, 20, -200}, 6}, {{108, 20, -30}, 9}}));
  const ShapePtr patella = both_sides(ellipsoid({70, -40, 24}, {22, 9, 23}));
  const ShapePtr bones = join(0, {femur, tibia, fibula, patella});
  return {{leg, {.value_hu = hu::kSkin}},
          {grow(-2.5f, leg), {.value_hu = hu::kFat}},
          {grow(-12, leg), {.value_hu = hu::kMuscle}},
          {bones, {.value_hu = hu::kCorticalBone}},
          {grow(-2.5f, bones), {.value_hu = hu::kSpongyBone}},
          {sphere({78, 4, -40}, 9), {.value_hu = hu::kFluid}}};
}

}  // namespace cutaway::phantom
