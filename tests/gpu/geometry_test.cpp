// Left is left: an asymmetric object followed from the grid to the pixels, whichever way the grid
// runs.
#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

/// Small balls at known patient positions: one towards each of left, anterior and superior, of
/// different sizes.
Volume three_balls(const VolumeGeometry& geometry) {
  return sampled_volume(geometry, [](glm::dvec3 x) {
    const double left = 8.0 - glm::distance(x, glm::dvec3(30, 0, 0));
    const double anterior = 6.0 - glm::distance(x, glm::dvec3(0, -30, 0));
    const double superior = 4.0 - glm::distance(x, glm::dvec3(0, 0, 30));
    return std::max({left, anterior, superior, -10.0});
  });
}

bool is_covered(const BytePicture& picture, glm::ivec2 at) {
  return picture.rgb(at) != glm::ivec3(0);
}

BytePicture seen_from(const std::shared_ptr<const LoadedVolume>& volume, glm::dvec3 eye,
                      glm::dvec3 up) {
  const Scene scene =
      scene_for({{"camera",
                  {{"projection", "orthographic"},
                   {"eye_mm", {eye.x, eye.y, eye.z}},
                   {"target_mm", {0, 0, 0}},
                   {"up", {up.x, up.y, up.z}},
                   {"view_height_mm", 100}}},
                 {"context",
                  {{"surface", {{"iso_value", 0}}},
                   {"shading", {{"name", "gooch"}}},
                   {"filters", Json::array()}}},
                 {"focus", {{"surface", {{"iso_value", 100}}}}},
                 {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}},
                 {"background", {{"colour", {0, 0, 0}}}}},
                volume, {100, 100});
  return GpuHarness::instance().render(scene, volume, settings_for(scene));
}

class EveryOrientation : public testing::TestWithParam<std::tuple<glm::dvec3, glm::dmat3>> {};

TEST_P(EveryOrientation, PatientsLeftIsOnTheViewersRight) {
  const auto [spacing, direction] = GetParam();
  const auto volume =
      load(three_balls(centred_geometry(glm::ivec3(110.0 / spacing), spacing, direction)));

  const BytePicture front = seen_from(volume, {0, -200, 0}, {0, 0, 1});
  EXPECT_TRUE(is_covered(front, {80, 50}));   // left, on the viewer's right
  EXPECT_TRUE(is_covered(front, {50, 20}));   // superior, above
  EXPECT_TRUE(is_covered(front, {50, 50}));   // anterior, in the middle
  EXPECT_FALSE(is_covered(front, {20, 50}));  // nothing on the patient's right
  EXPECT_FALSE(is_covered(front, {50, 80}));

  const BytePicture from_feet =
      seen_from(volume, {0, 0, -200}, {0, -1, 0});  // as axial slices are read
  EXPECT_TRUE(is_covered(from_feet, {80, 50}));
  EXPECT_TRUE(is_covered(from_feet, {50, 20}));
  EXPECT_FALSE(is_covered(from_feet, {20, 50}));

  const BytePicture from_left = seen_from(volume, {200, 0, 0}, {0, 0, 1});
  EXPECT_TRUE(is_covered(from_left, {20, 50}));  // anterior, on the viewer's left
  EXPECT_FALSE(is_covered(from_left, {80, 50}));
}

INSTANTIATE_TEST_SUITE_P(Orientation, EveryOrientation,
                         testing::Combine(testing::Values(glm::dvec3(1.0), kAnisotropicSpacingMm),
                                          testing::Values(glm::dmat3(1.0), oblique_direction(),
                                                          flipped_direction())));

TEST(Orientation, QuarterTurnsAboutASymmetricVolumePermutePixels) {
  const auto volume = load(sphere_volume(centred_geometry(64), 25.0));
  const BytePicture front = seen_from(volume, {0, -200, 0}, {0, 0, 1});
  for (const glm::dvec3 eye :
       {glm::dvec3(200, 0, 0), glm::dvec3(0, 200, 0), glm::dvec3(-200, 0, 0)}) {
    const PictureDifference difference = compare(seen_from(volume, eye, {0, 0, 1}), front);
    // A GPU's own filter need not round alike along its three axes.
    EXPECT_LE(difference.maximum, GpuHarness::instance().context().is_software() ? 0 : 1);
  }
}

}  // namespace
}  // namespace cutaway::test
