// What is under the pointer, by the cutaway lens' four cases, against closed forms of a ball.
#include "session/pick.h"

#include <gtest/gtest.h>

#include "unit/session/fakes.h"

namespace cutaway {
namespace {

// Context is the ball's surface at radius 100 mm, focus that at 50 mm; the viewer is at x = 500 and
// looks along -x.
class PickTest : public ::testing::Test {
 protected:
  PickTest() {
    scene.viewport = {100, 100};
    scene.camera = {.projection = Projection::orthographic,
                    .eye_mm = {500.0, 0.0, 0.0},
                    .target_mm = {0.0, 0.0, 0.0},
                    .up = {0.0, 0.0, 1.0},
                    .view_height_mm = 400.0};
    scene.context.surface.band.lower = 100.0;
    scene.focus.surface.band.lower = 150.0;
    scene.lens = {.mode = LensMode::cutaway,
                  .shape = {"sphere", Json::object()},
                  .centre_mm = {100.0, 0.0, 0.0},
                  .radius_mm = 60.0};
  }

  void expect_hit(glm::dvec2 position_px, PictureBranch branch, glm::dvec3 position_mm) const {
    const auto hit = pick(scene, volume, position_px);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->branch, branch);
    EXPECT_LT(glm::distance(hit->position_mm, position_mm), 0.5)
        << hit->position_mm.x << " " << hit->position_mm.y << " " << hit->position_mm.z;
  }

  testing::BallVolume volume{"ball"};
  Scene scene;
};

constexpr glm::dvec2 kMiddle{50.0, 50.0};

TEST_F(PickTest, WithoutALensTheContextIsSeen) {
  scene.lens.mode = LensMode::none;
  expect_hit(kMiddle, PictureBranch::context, {100.0, 0.0, 0.0});
}

TEST_F(PickTest, ALensOfRadiusZeroLeavesTheContext) {
  scene.lens.radius_mm = 0.0;
  expect_hit(kMiddle, PictureBranch::context, {100.0, 0.0, 0.0});
}

TEST_F(PickTest, InsideTheLensTheFocusIsSeen) {
  expect_hit(kMiddle, PictureBranch::focus, {50.0, 0.0, 0.0});
}

TEST_F(PickTest, TheFocusBehindTheLensIsNotSeenButTheWallOfTheCavityIs) {
  scene.lens.radius_mm = 30.0;
  expect_hit(kMiddle, PictureBranch::context, {70.0, 0.0, 0.0});
}

TEST_F(PickTest, AnOpenCapShowsNoWall) {
  scene.lens.radius_mm = 30.0;
  scene.lens.cap = LensCap::open;
  EXPECT_EQ(pick(scene, volume, kMiddle), std::nullopt);
}

TEST_F(PickTest, TheFocusThatTheLensCutsIsCapped) {
  scene.lens.centre_mm = {0.0, 0.0, 0.0};
  scene.lens.radius_mm = 40.0;
  scene.context.surface.band.lower = 250.0;  // nowhere
  expect_hit(kMiddle, PictureBranch::focus, {40.0, 0.0, 0.0});
}

TEST_F(PickTest, ContextInFrontOfTheLensHidesIt) {
  scene.lens.centre_mm = {0.0, 0.0, 0.0};
  expect_hit(kMiddle, PictureBranch::context, {100.0, 0.0, 0.0});
}

TEST_F(PickTest, ALensAroundEverythingShowsOnlyTheFocus) {
  scene.lens = {.mode = LensMode::cutaway,
                .shape = {"sphere", Json::object()},
                .centre_mm = {0.0, 0.0, 0.0},
                .radius_mm = 1000.0};
  expect_hit(kMiddle, PictureBranch::focus, {50.0, 0.0, 0.0});
  EXPECT_EQ(pick(scene, volume, {70.0, 50.0}), std::nullopt);  // 80 mm from the middle
}

TEST_F(PickTest, BesideTheLensTheContextIsSeen) {
  // 80 mm up, where the ball's surface is at x = 60
  expect_hit({50.0, 30.0}, PictureBranch::context, {60.0, 0.0, 80.0});
}

TEST_F(PickTest, BesideTheVolumeThereIsNothing) {
  EXPECT_EQ(pick(scene, volume, {5.0, 5.0}), std::nullopt);
}

// As the picture has it: no cut at the eye; behind the lens the context is met where the lens ends.
TEST_F(PickTest, ACameraInsideTheFocusLooksThroughIt) {
  scene.camera.eye_mm = {20.0, 0.0, 0.0};
  scene.lens = {.mode = LensMode::cutaway,
                .shape = {"sphere", Json::object()},
                .centre_mm = {20.0, 0.0, 0.0},
                .radius_mm = 10.0};
  expect_hit(kMiddle, PictureBranch::context, {10.0, 0.0, 0.0});
}

TEST_F(PickTest, TheLensIsDraggedOverTheContextAsIfItWereNotThere) {
  const glm::dvec3 centre = dragged_lens_centre(scene, volume, kMiddle);
  EXPECT_LT(glm::distance(centre, glm::dvec3(100.0, 0.0, 0.0)), 1e-9);
}

TEST_F(PickTest, BesideTheVolumeTheLensStaysInItsPlaneFacingTheViewer) {
  const glm::dvec3 centre = dragged_lens_centre(scene, volume, {50.0, 5.0});
  EXPECT_LT(glm::distance(centre, glm::dvec3(100.0, 0.0, 180.0)), 1e-9);
}

TEST_F(PickTest, ALensBehindTheViewerStaysWhereItIsBesideTheVolume) {
  scene.lens.centre_mm = {600.0, 0.0, 0.0};
  EXPECT_EQ(dragged_lens_centre(scene, volume, {50.0, 5.0}), scene.lens.centre_mm);
}

}  // namespace
}  // namespace cutaway
