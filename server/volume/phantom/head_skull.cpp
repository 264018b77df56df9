#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

ShapePtr orbital_rim() {
  return tube({{{17, -73, 20}, 4},
               {{26, -76, 30}, 4},
               {{41, -72, 30}, 4},
               {{52, -61, 22}, 5},
               {{54, -57, 10}, 5},
               {{50, -63, -4}, 4.5f},
               {{38, -72, -9}, 4},
               {{25, -76, -6}, 3.5f},
               {{17, -74, 4}, 3},
               {{17, -73, 20}, 4}});
}

/// Cheekbone with its arch back to the temple.
ShapePtr zygoma() {
  const ShapePtr body = ellipsoid({46, -63, -13}, {13, 11, 10});
  const ShapePtr arch = tube({{{50, -60, -12}, 5.5f},
                              {{59, -44, -10}, 3.6f},
                              {{63, -22, -7}, 3},
                              {{64, 0, -3}, 3.4f},
                              {{60, 10, 1}, 5}},
                             {1, 1, 0.65f});
  const ShapePtr to_maxilla = tube({{{40, -66, -18}, 7}, {{30, -64, -30}, 7}, {{26, -62, -40}, 6}});
  return join(5, {body, arch, to_maxilla});
}

ShapePtr maxilla() {
  const ShapePtr body = both_sides(ellipsoid({20, -58, -22}, {19, 22, 22}));
  const ShapePtr ridge = both_sides(tube({{{0, -85, -39}, 6},
                                          {{13, -81, -39}, 6},
                                          {{22, -70, -39}, 6.5f},
                                          {{27, -54, -39}, 7},
                                          {{28, -38, -38}, 6.5f}},
                                         {1, 1, 0.8f}));
  const ShapePtr palate = ellipsoid({0, -56, -36}, {26, 30, 4});
  const ShapePtr nasal =
      both_sides(tube({{{2.5f, -80, 20}, 3.8f}, {{3, -84, 8}, 3.4f}, {{3, -90, -2}, 2.6f}}));
  const ShapePtr side = both_sides(
      tube({{{11.5f, -74, 15}, 4}, {{16.5f, -76, -5}, 4.4f}, {{19.5f, -75, -28}, 6.5f}}));
  const ShapePtr spine = rod({{{0, -84, -34}, 4}, {{0, -93, -33}, 1.6f}});
  return join(5, {body, ridge, palate, nasal, side, spine});
}

ShapePtr skull_base() {
  const ShapePtr sphenoid = ellipsoid({0, -22, 2}, {24, 24, 15});
  const ShapePtr wing = both_sides(ellipsoid({40, -44, 8}, {16, 14, 26}));
  const ShapePtr petrous = both_sides(rod({{{56, 18, -6}, 14}, {{14, -4, -4}, 9}}));
  const ShapePtr mastoid = both_sides(rod({{{59, 24, -6}, 13}, {{56, 21, -28}, 8}}));
  const ShapePtr pterygoid = both_sides(rod({{{15, -28, -6}, 6}, {{16, -28, -36}, 3.5f}}));
  const ShapePtr clivus = rod({{{0, -8, 0}, 12}, {{0, 18, -30}, 8}});
  const ShapePtr condyle = both_sides(ellipsoid({18, 25, -38}, {8, 11, 6}));
  const ShapePtr protuberance = ellipsoid({0, 84, 0}, {14, 7, 8});
  return join(6, {sphenoid, wing, petrous, mastoid, pterygoid, clivus, condyle, protuberance});
}

/// The pear-shaped opening of the nose.
ShapePtr nasal_aperture() {
  return join(8, {sphere({0, -92, -8}, 6), both_sides(sphere({4.5f, -90, -21}, 8))});
}

/// Where the temporal muscle lies against the skull.
ShapePtr temporal_fossa() { return both_sides(ellipsoid({77, -44, 12}, {18, 24, 32})); }

}  // namespace

ShapePtr cranial_vault(float inset_mm) {
  return join(22, {ellipsoid({0, -16, 50}, glm::vec3(64, 72, 72) - inset_mm),
                   ellipsoid({0, 22, 48}, glm::vec3(73, 76, 76) - inset_mm),
                   both_sides(ellipsoid({32, -2, 20}, glm::vec3(40, 50, 42) - inset_mm)),
                   ellipsoid({0, 38, 6}, glm::vec3(60, 54, 46) - inset_mm)});
}

ShapePtr cranial_cavity() {
  const ShapePtr front = half_space({0, -40, 28}, {0, 0.05f, -1});
  const ShapePtr middle =
      meet(4, {half_space({0, 0, 18}, {0, 0, -1}), half_space({0, -16, 0}, {0, -1, 0})});
  const ShapePtr temporal = both_sides(ellipsoid({38, -4, 14}, {28, 38, 24}));
  const ShapePtr posterior = ellipsoid({0, 44, -1}, {52, 42, 30});
  return meet(5, {cranial_vault(14), join(7, {front, middle, temporal, posterior})});
}

ShapePtr orbits() {
  const ShapePtr globe_part = ellipsoid({34, -76, 12}, {18.5f, 20, 17});
  const ShapePtr apex = ellipsoid({24, -57, 12.5f}, {12, 12, 27}, {-0.42f, 0.9f, 0.02f});
  return both_sides(join(8, {globe_part, apex}));
}

ShapePtr skull() {
  const ShapePtr brow = both_sides(tube(
      {{{0, -78, 27}, 4.5f}, {{14, -78, 30}, 4.5f}, {{28, -75, 33}, 3.5f}, {{38, -71, 32}, 3}}));
  const ShapePtr vault = carve(14, cranial_vault(7.5f), temporal_fossa());
  const ShapePtr bones = join(
      8, {vault, brow, both_sides(orbital_rim()), both_sides(zygoma()), maxilla(), skull_base()});
  const ShapePtr foramen_magnum = rod({{{0, 33, -20}, 15}, {{0, 33, -60}, 17}});
  const ShapePtr openings = join(0, {orbits(), nasal_aperture(), nasal_cavity(), sinuses(),
                                     ear_canals(), foramen_magnum, cranial_cavity()});
  return carve(2, bones, openings);
}

}  // namespace cutaway::phantom
