#include "volume/ray_probe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/analytic_volumes.h"

namespace cutaway {
namespace {

constexpr RayInterval kEverywhere{0.0, 1e9};

TEST(IntersectGrid, FollowsTheAxesIncludingRaysWithinAFace) {
  const VolumeGeometry geometry = test::centred_geometry({11, 21, 31}, {1.0, 0.5, 2.0});
  const auto through = intersect_grid(geometry, {{-20.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->begin_mm, 15.0, 1e-12);
  EXPECT_NEAR(through->end_mm, 25.0, 1e-12);
  EXPECT_TRUE(intersect_grid(geometry, {{-20.0, 5.0, 30.0}, {1.0, 0.0, 0.0}}));
  EXPECT_FALSE(intersect_grid(geometry, {{-20.0, 5.001, 0.0}, {1.0, 0.0, 0.0}}));
}

TEST(IntersectGrid, BeginsAtTheEyeInsideAndIgnoresWhatLiesBehind) {
  const VolumeGeometry geometry = test::centred_geometry(11);
  const auto inside = intersect_grid(geometry, {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->begin_mm, 0.0);
  EXPECT_NEAR(inside->end_mm, 5.0, 1e-12);
  EXPECT_FALSE(intersect_grid(geometry, {{0.0, 0.0, 9.0}, {0.0, 0.0, 1.0}}));
}

/// The same by brute force: of the points where the ray crosses one of the six faces' planes,
/// those that lie on the box; and the ray's origin, where it is inside.
std::optional<RayInterval> box_by_its_faces(const VolumeGeometry& geometry, const PatientRay& ray) {
  constexpr double kOnBox = 1e-9;
  const glm::dvec3 half_mm = 0.5 * geometry.spacing_mm * glm::dvec3(geometry.size_voxels - 1);
  const glm::dvec3 middle_mm = geometry.origin_patient_mm + geometry.direction_patient * half_mm;
  const auto is_in_box = [&](glm::dvec3 position_mm) {
    const glm::dvec3 local = glm::transpose(geometry.direction_patient) * (position_mm - middle_mm);
    return glm::all(glm::lessThanEqual(glm::abs(local), half_mm + kOnBox));
  };
  std::vector<double> distances;
  if (is_in_box(ray.origin_mm)) distances.push_back(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 normal = geometry.direction_patient[axis];
    const double slant = glm::dot(normal, ray.direction);
    if (slant == 0.0) continue;
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec3 on_face = middle_mm + side * half_mm[axis] * normal;
      const double at_mm = glm::dot(normal, on_face - ray.origin_mm) / slant;
      if (at_mm >= 0.0 && is_in_box(ray.origin_mm + at_mm * ray.direction))
        distances.push_back(at_mm);
    }
  }
  if (distances.empty()) return std::nullopt;
  const auto [first, last] = std::ranges::minmax(distances);
  return RayInterval{first, last};
}

/// From all around and from within; every fourth along an axis of the grid.
PatientRay random_ray(std::mt19937& random, int number, const VolumeGeometry& geometry) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double reach_mm = number % 3 == 0 ? 10.0 : 60.0;
  const glm::dvec3 from = reach_mm * glm::dvec3(unit(random), unit(random), unit(random));
  if (number % 4 == 0) {
    const double sign = number % 8 == 0 ? 1.0 : -1.0;
    return {from, sign * geometry.direction_patient[(number / 8) % 3]};
  }
  const glm::dvec3 to = 15.0 * glm::dvec3(unit(random), unit(random), unit(random));
  return {from, glm::normalize(to - from)};
}

TEST(IntersectGrid, IsTheBoxesFacesForAHundredThousandRays) {
  std::mt19937 random(23);
  int met = 0;
  int missed = 0;
  for (const glm::dmat3& direction :
       {glm::dmat3(1.0), test::oblique_direction(), test::flipped_direction()}) {
    const VolumeGeometry geometry =
        test::centred_geometry({33, 41, 19}, test::kAnisotropicSpacingMm, direction);
    for (int i = 0; i < 34000; ++i) {
      const PatientRay ray = random_ray(random, i, geometry);
      const auto expected = box_by_its_faces(geometry, ray);
      const auto actual = intersect_grid(geometry, ray);
      const double length_mm = expected ? expected->end_mm - expected->begin_mm : 0.0;
      if (expected && length_mm < 1e-6) continue;  // a corner or an edge: either answer will do
      ASSERT_EQ(actual.has_value(), expected.has_value()) << i;
      ++(expected ? met : missed);
      if (!expected) continue;
      ASSERT_NEAR(actual->begin_mm, expected->begin_mm, 1e-7) << i;
      ASSERT_NEAR(actual->end_mm, expected->end_mm, 1e-7) << i;
    }
  }
  EXPECT_GT(met, 40000);
  EXPECT_GT(missed, 10000);
}

class EveryRay : public testing::TestWithParam<glm::dmat3> {};

/// The first-surface tolerance for a trilinear distance field of spacing h at radius r is h^2/(4
/// r); the largest spacing here is 2 mm.
TEST_P(EveryRay, MeetsTheSphereWhereTheClosedFormSays) {
  constexpr double kRadius = 20.0;
  const glm::dvec3 centre(3.0, -2.0, 1.0);
  const VolumeGeometry geometry =
      test::centred_geometry({64, 90, 32}, test::kAnisotropicSpacingMm, GetParam());
  const Volume volume = test::sphere_volume(geometry, 100.0, centre);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 out =
        glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    const glm::dvec3 aim = centre + 8.0 * glm::normalize(glm::dvec3(normal(random), 1.0, 0.5));
    const PatientRay ray{centre + 100.0 * out, glm::normalize(aim - centre - 100.0 * out)};
    const double along = glm::dot(ray.direction, centre - ray.origin_mm);
    const double beside2 = glm::dot(ray.origin_mm - centre, ray.origin_mm - centre) - along * along;
    const double expected_mm = along - std::sqrt(kRadius * kRadius - beside2);
    const auto found_mm = first_surface_mm(volume, ray, {100.0 - kRadius}, kEverywhere);
    ASSERT_TRUE(found_mm);
    EXPECT_NEAR(*found_mm, expected_mm, 2.0 * 2.0 / (4.0 * kRadius) * 1.2);
  }
}

INSTANTIATE_TEST_SUITE_P(RayProbe, EveryRay,
                         testing::Values(glm::dmat3(1.0), test::oblique_direction(),
                                         test::flipped_direction()));

TEST(FirstSurface, CountsTheStartWhereItIsInsideAlready) {
  const Volume volume = test::sphere_volume(test::centred_geometry(64), 0.0);
  const PatientRay ray{{0.0, 0.0, -40.0}, {0.0, 0.0, 1.0}};
  EXPECT_EQ(first_surface_mm(volume, ray, {-20.0}, {30.0, 100.0}), 30.0);
  EXPECT_NEAR(*first_surface_mm(volume, ray, {-20.0}, {10.0, 100.0}), 20.0, 0.013);
}

TEST(FirstSurface, StaysWithinItsLimitsAndTheGrid) {
  const Volume volume = test::sphere_volume(test::centred_geometry(64), 0.0);
  const PatientRay ray{{0.0, 0.0, -40.0}, {0.0, 0.0, 1.0}};
  EXPECT_FALSE(first_surface_mm(volume, ray, {-20.0}, {0.0, 19.0}));
  EXPECT_FALSE(first_surface_mm(volume, ray, {-20.0}, {80.0, 60.0}));
  EXPECT_FALSE(first_surface_mm(volume, ray, {1.0}, kEverywhere));
  EXPECT_FALSE(
      first_surface_mm(volume, {{0.0, 0.0, -40.0}, {0.0, 0.0, -1.0}}, {-20.0}, kEverywhere));
}

TEST(FirstSurface, FindsASlabOfOneVoxel) {
  const test::SlabField slab{.normal = {0.0, 0.0, 1.0}, .half_thickness_mm = 0.6};
  const Volume volume = test::slab_volume(test::centred_geometry(65), slab);
  const PatientRay ray{{0.3, 0.2, -100.0}, {0.0, 0.0, 1.0}};
  EXPECT_NEAR(*first_surface_mm(volume, ray, {-250.0}, kEverywhere), 99.5, 1e-4);
}

TEST(FirstSurface, MeetsABandFromEitherSideAndOneThatItJumpsOver) {
  const Volume volume = test::sphere_volume(test::centred_geometry(64), 0.0);  // minus the radius
  const PatientRay ray{{0.0, 0.0, -30.0}, {0.0, 0.0, 1.0}};
  EXPECT_NEAR(*first_surface_mm(volume, ray, {-20.0, -10.0}, kEverywhere), 10.0, 0.03);
  EXPECT_NEAR(*first_surface_mm(volume, ray, {-20.0, -19.999}, kEverywhere), 10.0, 0.03);
  const RayInterval from_within{25.0, 100.0};  // 5 mm from the centre, above the band
  EXPECT_NEAR(*first_surface_mm(volume, ray, {-20.0, -10.0}, from_within), 40.0, 0.03);
}

}  // namespace
}  // namespace cutaway
