#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

ShapePtr lower_face() {
  const ShapePtr middle = ellipsoid({0, -38, -12}, {57, 46, 50});
  const ShapePtr jaw = ellipsoid({0, -36, -54}, {44, 44, 40});
  const ShapePtr jaw_line = both_sides(
      tube({{{56, 6, -24}, 12}, {{51, 0, -56}, 11}, {{33, -46, -80}, 13}, {{10, -72, -85}, 13}}));
  const ShapePtr side = both_sides(
      tube({{{46, -56, -10}, 15}, {{56, -28, -8}, 13}, {{60, 4, -6}, 12}, {{60, 24, -14}, 11}}));
  const ShapePtr cheek = both_sides(
      join(12, {ellipsoid({33, -56, -34}, {20, 25, 26}), ellipsoid({45, -26, -33}, {17, 37, 33})}));
  const ShapePtr muzzle = ellipsoid({0, -69, -52}, {31, 27, 25});
  const ShapePtr outer_rim = both_sides(ellipsoid({50, -59, 9}, {13, 13, 18}));
  const ShapePtr chin = ellipsoid({0, -80, -86}, {19, 15, 13});
  const ShapePtr under_chin = ellipsoid({0, -34, -76}, {40, 44, 22});
  return join(14, {middle, jaw, jaw_line, side, outer_rim, cheek, muzzle, chin, under_chin});
}

ShapePtr brow() {
  return both_sides(
      tube({{{0, -82, 26}, 6}, {{16, -83, 28}, 6}, {{34, -76, 30}, 5.5f}, {{47, -66, 26}, 4}}));
}

ShapePtr nose() {
  const ShapePtr bridge = tube({{{0, -82, 22}, 6.5f}, {{0, -90, 8}, 6}, {{0, -101, -14}, 7.5f}});
  const ShapePtr tip = ellipsoid({0, -104, -21}, {9.5f, 9, 8.5f});
  const ShapePtr flank =
      both_sides(tube({{{8, -80, 8}, 6}, {{11, -84, -8}, 7}, {{13, -86, -20}, 7}}));
  const ShapePtr wing = both_sides(ellipsoid({11.5f, -95, -25}, {6.5f, 10, 7.5f}));
  const ShapePtr base = ellipsoid({0, -92, -26}, {9, 13, 7});
  const ShapePtr core = rod({{{0, -78, 12}, 9}, {{0, -84, -16}, 11}});
  return join(6, {join(9, {bridge, tip, flank, core}), wing, base});
}

ShapePtr lips() {
  const ShapePtr upper = both_sides(tube({{{0, -97, -50.5f}, 3.6f},
                                          {{5, -97.3f, -49.3f}, 4},
                                          {{14, -92.5f, -52}, 3.2f},
                                          {{25, -83, -54}, 1.5f}}));
  const ShapePtr lower = both_sides(tube({{{0, -95.5f, -60}, 5},
                                          {{9, -94, -60}, 4.8f},
                                          {{17, -89, -57.5f}, 3.2f},
                                          {{25, -82.5f, -54.5f}, 1.5f}}));
  return join(1, {upper, lower});
}

ShapePtr mouth_line() {
  return both_sides(tube({{{0, -99.5f, -55}, 1.3f},
                          {{10, -97, -54.3f}, 1.3f},
                          {{19, -90, -54.5f}, 1.2f},
                          {{28, -81, -54}, 1.2f}}));
}

/// Closed lids over the eyeballs.
ShapePtr lids() { return both_sides(ellipsoid({32, -72.5f, 12}, {15.5f, 14, 13.5f})); }

/// Thick from front to back, and cut to a little below the lids' surface.
ShapePtr lid_lines() {
  constexpr glm::vec3 kForward{1, 0.2f, 1};
  const ShapePtr lashes = tube({{{20.5f, -84, 8.5f}, 0.8f},
                                {{24, -85, 6.5f}, 1.1f},
                                {{33, -85, 5}, 1.2f},
                                {{40, -82.5f, 6.5f}, 1.1f},
                                {{45, -79, 9}, 0.8f}},
                               kForward);
  const ShapePtr crease = tube({{{21, -84, 16.5f}, 0.8f},
                                {{26, -84, 20}, 1},
                                {{34, -83, 21}, 1},
                                {{40, -80.5f, 19.5f}, 1},
                                {{45, -77.5f, 16.5f}, 0.8f}},
                               kForward);
  const ShapePtr skin_of_lids = grow(-1.1f, lids());
  return carve(0, both_sides(join(0, {lashes, crease})), skin_of_lids);
}

ShapePtr ear() {
  const ShapePtr plate = ellipsoid({75, 22, 4}, {5, 16, 28}, {0.1f, 0.15f, 1});
  const ShapePtr helix = tube({{{74, 10, 3}, 2.4f},
                               {{76, 6, 15}, 3},
                               {{79, 11, 28}, 3.5f},
                               {{82, 24, 33}, 3.7f},
                               {{84, 36, 25}, 3.7f},
                               {{82, 38, 10}, 3.5f},
                               {{78, 31, -8}, 3.5f},
                               {{75, 20, -20}, 5},
                               {{73, 12, -24}, 5.5f}});
  const ShapePtr antihelix =
      tube({{{78, 18, 22}, 2.5f}, {{80, 26, 12}, 3}, {{79, 25, -4}, 3}, {{76, 17, -13}, 3}});
  const ShapePtr tragus = ellipsoid({74, 6, -3}, {5, 4, 6});
  const ShapePtr concha = ellipsoid({82, 15, 1}, {8, 6.5f, 11});
  return join(2.5f, {carve(3, plate, concha), helix, antihelix, tragus});
}

ShapePtr hollows() {
  const ShapePtr orbit = both_sides(ellipsoid({30, -99, 11}, {18, 13, 11}));
  const ShapePtr temple = both_sides(ellipsoid({88, -46, 28}, {16, 30, 26}));
  const ShapePtr under_lip = ellipsoid({0, -105, -71}, {22, 12, 5});
  const ShapePtr fold =
      both_sides(tube({{{19, -93, -22}, 1.5f}, {{25, -92, -38}, 2}, {{32, -86, -56}, 2}}));
  return join(3, {orbit, temple, under_lip, fold});
}

}  // namespace

ShapePtr neck_outline() {
  const ShapePtr column =
      tube({{{0, 26, -20}, 48}, {{0, 30, -80}, 52}, {{0, 32, -120}, 55}, {{0, 30, -180}, 66}});
  const ShapePtr strap =
      both_sides(rod({{{60, 20, -24}, 11}, {{40, 2, -90}, 10}, {{16, -22, -170}, 9}}));
  const ShapePtr apple = ellipsoid({0, -27, -113}, {9, 8, 13});
  const ShapePtr shoulder = both_sides(rod({{{30, 54, -90}, 28}, {{96, 46, -176}, 30}}));
  return join(14, {column, strap, apple, shoulder});
}

ShapePtr head_skin() {
  const ShapePtr face = join(18, {cranial_vault(0), lower_face(), brow()});
  const ShapePtr hollowed = carve(12, face, hollows());
  const ShapePtr with_lids = join(7, {hollowed, lids()});
  const ShapePtr with_nose = join(7, {with_lids, nose()});
  const ShapePtr philtrum = rod({{{0, -98.5f, -37}, 1.6f}, {{0, -101.5f, -46}, 2.2f}});
  const ShapePtr mouth = join(5, {carve(4, with_nose, philtrum), lips()});
  const ShapePtr lined = carve(2, mouth, join(0, {mouth_line(), lid_lines()}));
  return join(3, {join(18, {lined, neck_outline()}), both_sides(ear())});
}

ShapePtr earring() { return sphere({77, 10, -28}, 3); }

}  // namespace cutaway::phantom
