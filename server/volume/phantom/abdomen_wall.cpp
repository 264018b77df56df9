#include "volume/phantom/abdomen_parts.h"

namespace cutaway::phantom {

namespace {

constexpr glm::vec3 kBroad{0.69f, 1, 1};  ///< trunks are broader than deep

ShapePtr thigh(float inset_mm) {
  return both_sides(tube({{{88, 6, -110}, 72 - inset_mm},
                          {{92, 4, -160}, 74 - inset_mm},
                          {{94, 4, -260}, 70 - inset_mm}}));
}

/// Shallow grooves: the backbone, the white line, and the outer edges of the straight muscles.
ShapePtr furrows() {
  const ShapePtr spine =
      tube({{{0, 127, 230}, 7}, {{0, 120, 80}, 9}, {{0, 119, -40}, 9}, {{0, 130, -110}, 6}});
  const ShapePtr middle = tube({{{0, -126, 170}, 9}, {{0, -116, 50}, 9}, {{0, -120, 0}, 7}});
  const ShapePtr outer = both_sides(tube(
      {{{84, -112, 150}, 10}, {{80, -101, 60}, 10}, {{82, -104, -20}, 10}, {{56, -126, -90}, 8}}));
  return join(4, {spine, middle, outer});
}

}  // namespace

ShapePtr abdomen_skin() {
  const ShapePtr trunk = tube({{{0, 6, 280}, 115},
                               {{0, 4, 200}, 114},
                               {{0, 3, 120}, 107},
                               {{0, 2, 40}, 99},
                               {{0, 3, -30}, 103},
                               {{0, 6, -90}, 108},
                               {{0, 8, -130}, 96}},
                              kBroad);
  const ShapePtr belly = ellipsoid({0, -50, -40}, {90, 54, 88});
  const ShapePtr pubis = ellipsoid({0, -52, -142}, {44, 36, 34});
  const ShapePtr buttock = both_sides(ellipsoid({62, 62, -128}, {64, 52, 66}));
  const ShapePtr body = join(26, {trunk, belly, join(9, {thigh(0), buttock, pubis})});
  return carve(18, carve(8, body, ellipsoid({0, -110, -16}, {5, 12, 7})), furrows());
}

ShapePtr abdomen_muscles() {
  const ShapePtr trunk = tube({{{0, 6, 280}, 98},
                               {{0, 4, 200}, 97},
                               {{0, 4, 120}, 91},
                               {{0, 2, 40}, 84},
                               {{0, 4, -30}, 85},
                               {{0, 8, -100}, 86},
                               {{0, 8, -140}, 78}},
                              kBroad);
  const ShapePtr back = both_sides(tube({{{34, 76, 280}, 24},
                                         {{36, 76, 120}, 26},
                                         {{34, 70, 20}, 28},
                                         {{28, 76, -60}, 26},
                                         {{20, 86, -130}, 12}}));
  const ShapePtr buttock = both_sides(
      join(10, {ellipsoid({60, 66, -128}, {52, 34, 56}), ellipsoid({118, 24, -90}, {26, 46, 52})}));
  return join(8, {trunk, back, buttock, thigh(13)});
}

ShapePtr abdomen_cavity() {
  return tube({{{0, 2, 280}, 88},
               {{0, 0, 200}, 86},
               {{0, -2, 120}, 80},
               {{0, -4, 40}, 73},
               {{0, -2, -30}, 72},
               {{0, 4, -90}, 62},
               {{0, 8, -140}, 44}},
              kBroad);
}

ShapePtr deep_muscles() {
  const ShapePtr psoas = tube({{{30, 44, 100}, 8},
                               {{40, 36, 40}, 18},
                               {{50, 26, -20}, 22},
                               {{66, 4, -70}, 21},
                               {{82, -24, -120}, 17},
                               {{100, -2, -180}, 14}});
  const ShapePtr quadratus = tube({{{66, 56, 110}, 10}, {{76, 58, 40}, 14}, {{82, 60, -20}, 13}});
  const ShapePtr iliacus = ellipsoid({88, 14, -64}, {17, 42, 40}, {0.35f, 0, 1});
  return both_sides(join(3, {psoas, quadratus, iliacus}));
}

}  // namespace cutaway::phantom
