#include "volume/phantom/knees_parts.h"

namespace cutaway::phantom {

namespace {

ShapePtr medial_condyle() {
  return join(8,
              {ellipsoid({47, 4, 23}, {16.5f, 30, 20.5f}), ellipsoid({46, 20, 24}, {15, 20, 21})});
}

ShapePtr lateral_condyle() {
  return join(
      8, {ellipsoid({93, 2, 24}, {16.5f, 31, 20.5f}), ellipsoid({94, 19, 25}, {15, 19, 20.5f})});
}

/// The front of the femur, grooved for the kneecap; the outer lip is higher.
ShapePtr trochlea() {
  const ShapePtr front =
      join(12, {ellipsoid({56, -16, 36}, {16, 16, 22}), ellipsoid({86, -17, 38}, {17, 18, 24})});
  return carve(8, front, tube({{{70, -44, 76}, 10}, {{69, -40, 44}, 10}, {{69, -32, 12}, 9}}));
}

ShapePtr plateau() {
  const ShapePtr medial = ellipsoid({49, 8, -15}, {20, 25, 17});
  const ShapePtr lateral = ellipsoid({91, 8, -15}, {19, 23, 17});
  const ShapePtr middle = ellipsoid({70, 4, -16}, {26, 23, 17});
  const ShapePtr top = half_space({0, 0, -3}, {0, -0.09f, 1});
  const ShapePtr flat = meet(4, {join(10, {medial, lateral, middle}), top});
  const ShapePtr dish = both_sides(sphere({91, 6, 44}, 48));
  const ShapePtr spikes = join(2, {rod({{{65, 6, -6}, 4.5f}, {{66, 7, 4}, 1.6f}}),
                                   rod({{{75, 7, -6}, 4.5f}, {{74, 8, 3}, 1.6f}})});
  return join(3, {carve(2, flat, dish), spikes});
}

}  // namespace

ShapePtr femur() {
  const ShapePtr shaft = tube({{{70, -2, 40}, 25},
                               {{71, -4, 62}, 21},
                               {{73, -5, 90}, 16},
                               {{76, -7, 120}, 14},
                               {{80, -8, 190}, 13.5f}},
                              {0.9f, 1, 1});
  const ShapePtr epicondyles =
      join(4, {ellipsoid({34, 4, 34}, {8, 11, 11}), ellipsoid({106, 4, 34}, {7, 10, 10})});
  const ShapePtr adductor_tubercle = ellipsoid({40, 4, 48}, {7, 7, 8});
  const ShapePtr lower_end = join(9, {medial_condyle(), lateral_condyle(), trochlea(), shaft});
  const ShapePtr notch =
      tube({{{70, 52, 20}, 13}, {{70, 22, 14}, 11}, {{70, 0, 2}, 9}}, {1, 1, 0.75f});
  return both_sides(carve(5, join(6, {lower_end, epicondyles, adductor_tubercle}), notch));
}

ShapePtr tibia() {
  const ShapePtr shaft = tube({{{70, 4, -20}, 27},
                               {{70, 3, -38}, 23},
                               {{70, 1, -62}, 17},
                               {{69, 1, -100}, 13.5f},
                               {{69, 1, -190}, 12.5f}},
                              {0.92f, 1, 1});
  const ShapePtr crest = tube(
      {{{74, -22, -48}, 5}, {{73, -18, -80}, 5}, {{70, -15, -130}, 4.5f}, {{69, -14, -190}, 4.5f}});
  const ShapePtr tuberosity = ellipsoid({73, -24, -44}, {9, 8, 15});
  const ShapePtr below_top = half_space({0, 0, -12}, {0, 0, 1});
  return both_sides(
      join(5, {plateau(), join(9, {meet(6, {shaft, below_top}), crest, tuberosity})}));
}

ShapePtr fibula() {
  const ShapePtr head = ellipsoid({107, 23, -24}, {10, 10.5f, 11});
  const ShapePtr tip = rod({{{109, 26, -20}, 5}, {{110, 27, -12}, 2.5f}});
  const ShapePtr shaft = tube({{{107, 23, -30}, 7},
                               {{107, 22, -48}, 5.4f},
                               {{107, 20, -90}, 6.4f},
                               {{105, 18, -190}, 6.6f}});
  return both_sides(join(4, {head, tip, shaft}));
}

ShapePtr patella() {
  const ShapePtr disc = ellipsoid({71, -46, 38}, {21.5f, 8.5f, 20.5f});
  const ShapePtr apex = rod({{{71, -47, 26}, 7.5f}, {{70, -46, 14}, 3.6f}});
  const ShapePtr ridge = tube({{{70, -40, 48}, 4}, {{70, -39, 38}, 5}, {{70, -40, 28}, 4}});
  return both_sides(join(6, {disc, apex, ridge}));
}

ShapePtr knee_marrow() {
  const ShapePtr of_femur =
      tube({{{71, -4, 76}, 5}, {{73, -5, 92}, 9}, {{76, -7, 120}, 9.3f}, {{80, -8, 190}, 9}});
  const ShapePtr of_tibia =
      tube({{{70, 1, -62}, 5}, {{69, 1, -84}, 8.4f}, {{69, 1, -110}, 8.6f}, {{69, 1, -190}, 8}});
  const ShapePtr of_fibula =
      tube({{{107, 21, -60}, 2.4f}, {{107, 20, -90}, 3.2f}, {{105, 18, -190}, 3.2f}});
  return both_sides(join(0, {of_femur, of_tibia, of_fibula}));
}

ShapePtr knee_cartilage() {
  const ShapePtr rolling = join(8, {medial_condyle(), lateral_condyle(), trochlea()});
  const ShapePtr facing_joint =
      join(4, {half_space({0, 0, 26}, {0, 0, 1}), half_space({0, -14, 0}, {0, 1, 0}),
               half_space({0, 24, 0}, {0, -1, 0})});
  const ShapePtr on_femur =
      meet(2, {grow(2.6f, rolling), facing_joint, half_space({0, 0, 62}, {0, 0, 1})});
  const ShapePtr on_tibia = meet(2, {grow(2.4f, plateau()), half_space({0, 0, -8}, {0, 0, -1})});
  const ShapePtr on_patella =
      meet(2, {ellipsoid({71, -45, 39}, {20, 12, 18}), half_space({0, -43, 0}, {0, -1, 0})});
  return both_sides(join(0, {on_femur, on_tibia, on_patella}));
}

ShapePtr menisci() {
  const auto horseshoe = [](glm::vec3 centre, float radius, float opening) {
    const auto at = [&](float x, float y) {
      return Knot{centre + glm::vec3(radius * x, radius * y, 0), 3.6f};
    };
    return tube({at(opening, 0.95f), at(-0.1f * opening, 1.15f), at(-0.8f * opening, 0.75f),
                 at(-opening, 0), at(-0.8f * opening, -0.75f), at(-0.1f * opening, -1.1f),
                 at(opening, -0.9f)});
  };
  return both_sides(join(0, {horseshoe({50, 7, 0}, 16, 1), horseshoe({91, 7, 0}, 15, -1)}));
}

ShapePtr bone_cyst() { return ellipsoid({85, 6, -34}, {8, 8, 9}); }

}  // namespace cutaway::phantom
