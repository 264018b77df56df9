#include "volume/phantom/abdomen_parts.h"

namespace cutaway::phantom {

ShapePtr diaphragm_dome() {
  return join(20, {ellipsoid({-62, 0, 96}, {78, 84, 82}), ellipsoid({64, 4, 92}, {74, 82, 76}),
                   ellipsoid({0, -10, 80}, {120, 84, 84})});
}

ShapePtr lung_bases() {
  const ShapePtr chest =
      meet(4, {grow(-3, abdomen_cavity()), half_space({0, 0, 104}, {0, -0.5f, -1})});
  const ShapePtr mediastinum =
      join(14, {tube({{{0, 60, 280}, 34}, {{0, 60, 100}, 34}}), grow(5, heart())});
  return carve(5, carve(4, chest, diaphragm_dome()), mediastinum);
}

ShapePtr heart() { return ellipsoid({22, -34, 206}, {60, 44, 36}); }

ShapePtr liver() {
  const ShapePtr right = ellipsoid({-70, 4, 100}, {72, 74, 74});
  const ShapePtr left = ellipsoid({4, -36, 132}, {74, 40, 36});
  const ShapePtr lower_face = half_space({-70, 0, 42}, {0.42f, 0.1f, -1});
  const ShapePtr kidney_bed = ellipsoid({-66, 66, 52}, {36, 34, 60});
  const ShapePtr whole = meet(10, {join(24, {right, left}), lower_face, grow(-4, abdomen_cavity()),
                                   grow(-3, diaphragm_dome())});
  return carve(8, whole, kidney_bed);
}

ShapePtr gallbladder() { return rod({{{-34, -22, 72}, 8}, {{-48, -52, 50}, 14}}); }

ShapePtr spleen() {
  const ShapePtr whole = ellipsoid({90, 38, 122}, {26, 40, 52}, {-0.15f, 0.1f, 1});
  const ShapePtr hilum = ellipsoid({60, 20, 114}, {20, 26, 34});
  return meet(4, {carve(8, whole, hilum), grow(-4, abdomen_cavity())});
}

namespace {

ShapePtr kidney(glm::vec3 centre_mm) {
  const ShapePtr whole = ellipsoid(centre_mm, {27, 25, 55}, {-0.22f, 0.12f, 1});
  const ShapePtr hilum = ellipsoid(centre_mm + glm::vec3(-26, -6, 2), {13, 13, 18});
  return carve(8, whole, hilum);
}

ShapePtr kidney_pelvis(glm::vec3 centre_mm) {
  const ShapePtr pelvis = ellipsoid(centre_mm + glm::vec3(-14, -3, 2), {10, 7, 17});
  const ShapePtr ureter = tube({{centre_mm + glm::vec3(-20, -4, -8), 4},
                                {centre_mm + glm::vec3(-28, -14, -60), 2.6f},
                                {{34, 10, -70}, 2.4f},
                                {{22, 0, -128}, 2.4f}});
  return join(4, {pelvis, ureter});
}

constexpr glm::vec3 kLeftKidney{68, 46, 66};
constexpr glm::vec3 kRightKidneyReflected{66, 46,
                                          50};  ///< the right one lies lower, under the liver

}  // namespace

ShapePtr kidneys() {
  return join(0, {kidney(kLeftKidney), reflected(kidney(kRightKidneyReflected))});
}

ShapePtr kidney_pelves() {
  return join(0, {kidney_pelvis(kLeftKidney), reflected(kidney_pelvis(kRightKidneyReflected))});
}

ShapePtr pancreas() {
  const ShapePtr whole = tube({{{-26, -8, 52}, 15},
                               {{-14, -18, 66}, 13},
                               {{8, -26, 76}, 10},
                               {{44, -10, 86}, 10},
                               {{78, 14, 98}, 8}});
  return roughen({3, 9, 41}, whole);
}

ShapePtr bladder() { return ellipsoid({0, -34, -128}, {37, 32, 29}); }

}  // namespace cutaway::phantom
