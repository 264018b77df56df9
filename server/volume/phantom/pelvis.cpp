#include "volume/phantom/abdomen_parts.h"

namespace cutaway::phantom {

namespace {

constexpr glm::vec3 kHip{90, -4, -134};  ///< centre of the left femoral head

/// A bowl-shaped plate, thicker along its crest.
ShapePtr iliac_wing() {
  const ShapePtr bowl = ellipsoid({18, -10, -38}, {114, 120, 100});
  const ShapePtr plate = meet(0, {grow(3, bowl), complement(grow(-3, bowl))});
  const ShapePtr outline = join(16, {ellipsoid({100, 12, -72}, {80, 74, 46}, {0, 0.2f, 1}),
                                     ellipsoid({86, 10, -110}, {40, 42, 34})});
  const ShapePtr beside = half_space({36, 0, 0}, {-1, 0, 0});
  const ShapePtr crest = tube({{{110, -54, -86}, 6.5f},
                               {{127, -34, -56}, 6},
                               {{131, -4, -34}, 6},
                               {{125, 30, -27}, 6},
                               {{108, 60, -35}, 6.5f},
                               {{82, 80, -56}, 7.5f},
                               {{54, 88, -82}, 8}});
  return join(4, {meet(3, {plate, outline, beside}), crest});
}

ShapePtr hip_bone() {
  const ShapePtr front_spine = ellipsoid({98, -42, -110}, {8, 8, 11});
  const ShapePtr sacral_part = ellipsoid({54, 62, -88}, {11, 24, 30}, {-0.25f, 0.1f, 1});
  const ShapePtr arcuate = tube({{{52, 54, -100}, 11}, {{70, 30, -112}, 12}, {{82, 6, -116}, 16}});
  const ShapePtr socket = sphere(kHip + glm::vec3(-3, 2, 2), 32);
  const ShapePtr upper_ramus = tube(
      {{{78, -20, -126}, 12}, {{54, -38, -134}, 8}, {{30, -48, -142}, 7.5f}, {{8, -50, -148}, 9}});
  const ShapePtr symphysis = ellipsoid({9, -48, -156}, {8, 9, 20});
  const ShapePtr lower_ramus = tube({{{10, -46, -170}, 6.5f},
                                     {{28, -30, -186}, 6.5f},
                                     {{48, -6, -198}, 8},
                                     {{58, 16, -196}, 11}});
  const ShapePtr ischium =
      tube({{{82, 18, -134}, 16}, {{72, 28, -160}, 12.5f}, {{60, 24, -194}, 14}});
  const ShapePtr whole = join(7, {iliac_wing(), front_spine, sacral_part, arcuate, socket,
                                  upper_ramus, symphysis, lower_ramus, ischium});
  const ShapePtr opening = half_space(kHip + glm::vec3(3, 0, 0), {-1, 0.25f, 0.6f});
  const ShapePtr cup =
      join(2, {sphere(kHip, 26.5f), meet(4, {sphere(kHip + glm::vec3(8, 0, -4), 31), opening})});
  return carve(2, whole, cup);
}

}  // namespace

ShapePtr pelvis() { return both_sides(hip_bone()); }

ShapePtr sacrum() {
  const ShapePtr top = join(8, {ellipsoid({0, 58, -92}, {27, 18, 14}, {0, 0.5f, 1}),
                                both_sides(ellipsoid({34, 66, -96}, {20, 16, 22}))});
  const ShapePtr wedge =
      join(12, {ellipsoid({0, 74, -112}, {42, 14, 18}), ellipsoid({0, 84, -132}, {32, 11, 18}),
                ellipsoid({0, 88, -152}, {23, 9, 15})});
  const ShapePtr coccyx = tube({{{0, 88, -162}, 8}, {{0, 82, -180}, 6}, {{0, 70, -194}, 4}});
  const ShapePtr crest = tube({{{0, 84, -84}, 4}, {{0, 96, -108}, 5}, {{0, 98, -136}, 4}});
  const ShapePtr holes =
      both_sides(join(0, {rod({{{21, 40, -104}, 5}, {{21, 120, -112}, 4}}),
                          rod({{{18, 40, -122}, 4.6f}, {{18, 120, -128}, 3.6f}}),
                          rod({{{15, 40, -140}, 4.2f}, {{15, 120, -144}, 3.2f}})}));
  const ShapePtr canal = tube({{{0, 76, -70}, 9}, {{0, 84, -104}, 6}, {{0, 92, -140}, 3}});
  return carve(2, join(6, {top, wedge, coccyx, crest}), join(0, {holes, canal}));
}

ShapePtr thigh_bones() {
  const ShapePtr head = sphere(kHip, 23.5f);
  const ShapePtr neck = rod({{kHip, 15}, {{122, 6, -156}, 16}});
  const ShapePtr greater = ellipsoid({138, 14, -154}, {13, 18, 21});
  const ShapePtr lesser = ellipsoid({110, 22, -194}, {10, 9, 13});
  const ShapePtr shaft = tube({{{128, 10, -164}, 18}, {{124, 6, -200}, 16}, {{120, 0, -260}, 15}});
  return both_sides(join(6, {head, neck, greater, lesser, shaft}));
}

ShapePtr thigh_marrow() {
  return both_sides(rod({{{124, 6, -196}, 6}, {{122, 3, -212}, 9}, {{120, 0, -270}, 9}}));
}

}  // namespace cutaway::phantom
