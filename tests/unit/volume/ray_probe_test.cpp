#include "volume/ray_probe.h"

#include <gtest/gtest.h>

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
