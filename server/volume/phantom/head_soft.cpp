#include "volume/phantom/head_parts.h"

namespace cutaway::phantom {

namespace {

constexpr glm::vec3 kEye{32, -73, 12};  ///< centre of the left one

ShapePtr fissure() { return rounded_box({0, 10, 90}, {1.6f, 100, 62}, 1); }

ShapePtr inside_dura() { return grow(-2.5f, cranial_cavity()); }

}  // namespace

ShapePtr head_muscles() {
  const ShapePtr masseter =
      tube({{{60, -28, -14}, 6}, {{58, -14, -40}, 7}, {{54, -6, -62}, 5}}, {1, 0.5f, 1});
  const ShapePtr temporalis = ellipsoid({58, -22, 26}, {11, 34, 42}, {0.12f, 0, 1});
  const ShapePtr cheek =
      tube({{{38, -30, -50}, 3}, {{34, -62, -50}, 3}, {{22, -80, -54}, 4}}, {1, 1, 0.4f});
  const ShapePtr pterygoid = rod({{{22, -26, -20}, 9}, {{44, -6, -50}, 9}});
  const ShapePtr tongue = ellipsoid({0, -44, -60}, {22, 34, 16});
  const ShapePtr mouth_floor = ellipsoid({0, -42, -76}, {26, 32, 9});
  const ShapePtr mouth_ring = ellipsoid({0, -76, -54}, {28, 16, 18});
  const ShapePtr nape = both_sides(ellipsoid({22, 64, -48}, {24, 24, 50}));
  return join(3, {both_sides(join(2, {masseter, temporalis, cheek, pterygoid})), tongue,
                  mouth_floor, mouth_ring, nape, grow(-6, neck_outline())});
}

ShapePtr eyeballs() { return both_sides(sphere(kEye, 12)); }

ShapePtr eye_lenses() {
  return both_sides(ellipsoid(kEye + glm::vec3(0, -9, 0), {4.5f, 2.2f, 4.5f}));
}

ShapePtr orbital_muscles() {
  const glm::vec3 apex{15, -38, 13};
  const auto muscle = [&](glm::vec3 at_eye) {
    return tube(
        {{kEye + at_eye, 1.2f}, {0.5f * (kEye + at_eye * 1.5f + apex), 2.4f}, {apex, 1.4f}});
  };
  const ShapePtr nerve =
      tube({{kEye + glm::vec3(-1, 11, 0), 2.2f}, {{25, -50, 11}, 2.2f}, {{13, -34, 14}, 2}});
  return both_sides(join(0.5f, {muscle({12.5f, 0, 0}), muscle({-12.5f, 0, 0}),
                                muscle({0, 0, 12.5f}), muscle({0, 0, -12.5f}), nerve}));
}

ShapePtr cerebrum() {
  const ShapePtr below_tentorium = ellipsoid({0, 46, -8}, {56, 46, 28});
  const ShapePtr above = carve(4, inside_dura(), below_tentorium);
  const ShapePtr temporal = both_sides(ellipsoid({38, -4, 14}, {23, 33, 21}));
  const ShapePtr hemispheres =
      carve(3, join(3, {above, meet(3, {temporal, inside_dura()})}), fissure());
  return groove({.depth_mm = 10, .spacing_mm = 17, .width = 0.2f, .seed = 3}, hemispheres);
}

ShapePtr cerebellum() {
  const ShapePtr lobes = both_sides(ellipsoid({22, 50, -7}, {26, 27, 20}));
  const ShapePtr vermis = ellipsoid({0, 52, -4}, {12, 24, 18});
  const ShapePtr whole = meet(3, {join(4, {lobes, vermis}), inside_dura()});
  return groove({.depth_mm = 3, .spacing_mm = 8, .width = 0.2f, .seed = 19}, whole);
}

ShapePtr brainstem() {
  const ShapePtr pons = ellipsoid({0, 16, -4}, {16, 13, 13});
  const ShapePtr stem =
      tube({{{0, 8, 22}, 13}, {{0, 18, -6}, 11}, {{0, 28, -32}, 7}, {{0, 34, -60}, 5.5f}});
  const ShapePtr cord =
      tube({{{0, 34, -56}, 5.5f}, {{0, 33, -100}, 5.5f}, {{0, 35, -170}, 5.5f}}, {0.8f, 1, 1});
  return join(4, {pons, stem, cord});
}

ShapePtr ventricles() {
  const ShapePtr lateral = tube({{{7, -34, 36}, 4},
                                 {{9, -10, 46}, 5},
                                 {{13, 18, 47}, 6},
                                 {{22, 38, 36}, 6.5f},
                                 {{30, 30, 18}, 4},
                                 {{34, 8, 8}, 2.5f}});
  const ShapePtr third = ellipsoid({0, 0, 28}, {2.4f, 14, 10});
  const ShapePtr fourth = ellipsoid({0, 32, -8}, {7, 5, 10});
  return join(2, {both_sides(lateral), third, fourth});
}

}  // namespace cutaway::phantom
