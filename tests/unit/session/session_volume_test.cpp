// Opening volumes: progress, cancel, failure, and what happens to the scene meanwhile.
#include <gmock/gmock.h>

#include "scene/styles.h"
#include "unit/session/session_fixture.h"

namespace cutaway {
namespace {

using ::testing::ElementsAre;
using SessionVolumeTest = testing::SessionFixture;

TEST_F(SessionVolumeTest, ReportsProgressThenReadyThenTheScene) {
  viewport(640, 480);
  scene({{"volume", "ball"}});
  library.progress(LoadStage::read, 0.0);
  strand->run();
  library.progress(LoadStage::decode, 0.5);
  strand->run();
  library.finish();
  strand->run();
  EXPECT_THAT(loading_stages(), ElementsAre("read", "decode", "ready"));
  EXPECT_EQ(client.texts.back()["type"], "scene");
}

TEST_F(SessionVolumeTest, ALookThatNobodyTouchedFollowsTheVolume) {
  library.first_style = "night";
  show_ball();
  const auto background = [this] { return client.last("scene")["scene"]["background"]; };
  library.first_style = "brain";
  open("head");
  EXPECT_EQ(background(), style("brain").scene.at("background"));
  scene({{"background", {{"colour", {0.5, 0.5, 0.5}}}}});
  library.first_style = "angiography";
  open("vessels");
  EXPECT_EQ(background(), (Json{{"colour", {0.5, 0.5, 0.5}}}));
  EXPECT_EQ(rendered().focus.shading.parameters.at("gamma"),
            style("brain").scene.at(Json::json_pointer("/focus/shading/gamma")));
}

TEST_F(SessionVolumeTest, ShowsAPreparedVolumeOnceItIsReady) {
  show_ball();
  library.prepares = true;
  scene({{"preparation", {{"focus_islands_ml", 0.5}}}});
  ASSERT_EQ(library.preparing.size(), 1U);
  EXPECT_EQ(library.preparing[0]->scene.preparation.focus_islands_ml, 0.5);
  scene({{"light", {{"direction", {1, 0, 0}}}}});
  EXPECT_EQ(library.preparing.size(), 1U) << "a light asks for no other volume";
  EXPECT_FALSE(library.preparing[0]->withdrawn);
  come_to_rest();
  ASSERT_TRUE(frames.idle());
  library.preparing[0]->ready();
  strand->run();
  EXPECT_FALSE(frames.idle()) << "the same scene, of another volume";
  EXPECT_EQ(rendered().preparation.focus_islands_ml, 0.5);
}

TEST_F(SessionVolumeTest, WithdrawsAPreparationThatAnotherReplaces) {
  show_ball();
  library.prepares = true;
  scene({{"preparation", {{"focus_islands_ml", 0.5}}}});
  scene({{"focus", {{"surface", {{"iso_value", 180.0}}}}}});
  ASSERT_EQ(library.preparing.size(), 2U);
  EXPECT_TRUE(library.preparing[0]->withdrawn);
  EXPECT_FALSE(library.preparing[1]->withdrawn);
}

TEST_F(SessionVolumeTest, ThousandsOfProgressReportsBecomeAFew) {
  scene({{"volume", "ball"}});
  for (int i = 0; i <= 10'000; ++i) {
    library.progress(LoadStage::read, i / 10'000.0);
    strand->run();
  }
  EXPECT_LE(loading_stages().size(), 22);
  EXPECT_EQ(client.last("loading")["fraction"], 1.0);
}

TEST_F(SessionVolumeTest, CancelKeepsTheVolumeThatWasShown) {
  show_ball();
  const std::uint32_t asking = scene({{"volume", "other"}});
  strand->advance(Milliseconds(1000.0));
  receive({{"type", "cancel_load"}});
  EXPECT_TRUE(library.wishes.back()->withdrawn);
  EXPECT_THAT(loading_stages(), ElementsAre("cancelled"));
  EXPECT_EQ(client.last("scene")["input"], asking) << "no picture will show it";
  scene({{"lens", {{"radius_mm", 10.0}}}});
  EXPECT_EQ(rendered().volume, "ball");
}

TEST_F(SessionVolumeTest, CancelWithNothingToCancelIsNoError) {
  receive({{"type", "cancel_load"}});
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionVolumeTest, FailureNamesTheInputAndKeepsTheVolumeThatWasShown) {
  show_ball();
  const std::uint32_t asking = scene({{"volume", "broken"}});
  library.fail(
      Error({.code = ErrorCode::volume_refused, .message = "truncated", .field = "broken.nii"}));
  strand->run();
  expect_error("volume-refused", "broken.nii");
  EXPECT_EQ(client.last("error")["input"], asking);
  EXPECT_THAT(loading_stages(), ElementsAre("failed"));
  scene({{"lens", {{"radius_mm", 10.0}}}});
  EXPECT_EQ(rendered().volume, "ball");
}

TEST_F(SessionVolumeTest, AfterAFailureTheSameVolumeCanBeTriedAgain) {
  show_ball();
  scene({{"volume", "other"}});
  library.fail(Error({.code = ErrorCode::volume_refused, .message = "no"}));
  strand->run();
  open("other");
  EXPECT_EQ(rendered().volume, "other");
}

TEST_F(SessionVolumeTest, AnotherVolumeWithdrawsTheWishForTheFirst) {
  scene({{"volume", "first"}});
  scene({{"volume", "second"}});
  ASSERT_EQ(library.wishes.size(), 2);
  EXPECT_TRUE(library.wishes[0]->withdrawn);
  EXPECT_EQ(client.last("loading")["volume"], "first");
  EXPECT_EQ(client.last("loading")["stage"], "cancelled");
}

TEST_F(SessionVolumeTest, AskingTwiceForTheSameVolumeOpensItOnce) {
  scene({{"volume", "ball"}});
  scene({{"volume", "ball"}});
  EXPECT_EQ(library.wishes.size(), 1);
}

TEST_F(SessionVolumeTest, AskingForTheShownVolumeStopsOpeningTheOther) {
  show_ball();
  scene({{"volume", "other"}});
  scene({{"volume", "ball"}});
  EXPECT_TRUE(library.wishes.back()->withdrawn);
  EXPECT_THAT(loading_stages(), ElementsAre("cancelled"));
}

TEST_F(SessionVolumeTest, WhileLoadingTheOldVolumeIsShownAndChangesAreKeptForTheNewOne) {
  show_ball();
  scene({{"volume", "other"}});
  scene({{"background", {{"colour", {1, 0, 0}}}}});
  const Scene meanwhile = rendered();
  EXPECT_EQ(meanwhile.volume, "ball");
  EXPECT_EQ(meanwhile.background.colour, glm::dvec3(1, 0, 0));
  come_to_rest();
  library.finish();
  strand->run();
  const Scene after = rendered();
  EXPECT_EQ(after.volume, "other");
  EXPECT_EQ(after.background.colour, glm::dvec3(1, 0, 0));
}

TEST_F(SessionVolumeTest, ChangesThatComeBeforeTheFirstVolumeAreKept) {
  scene({{"background", {{"colour", {1, 0, 0}}}}});
  viewport(640, 480);
  scene({{"volume", "ball"}});
  scene({{"lens", {{"radius_mm", 33.0}}}});
  library.finish();
  strand->run();
  const Scene shown = rendered();
  EXPECT_EQ(shown.background.colour, glm::dvec3(1, 0, 0));
  EXPECT_EQ(shown.lens.radius_mm, 33.0);
}

TEST_F(SessionVolumeTest, TheFirstPictureNamesTheNewestInputThatCameWhileItWasOpened) {
  viewport(640, 480);
  scene({{"volume", "ball"}});
  const std::uint32_t newest = scene({{"lens", {{"radius_mm", 33.0}}}});
  library.finish();
  strand->run();
  rendered();
  EXPECT_EQ(client.frames.back().header.input, newest);
}

TEST_F(SessionVolumeTest, AnotherVolumeKeepsTheStyleAndChoosesPlacesAnew) {
  show_ball();
  scene({{"background", {{"colour", {1, 0, 0}}}},
         {"camera", {{"eye_mm", {900, 0, 0}}, {"vertical_fov_degrees", 45}}},
         {"lens", {{"cap", "open"}, {"radius_mm", 5.0}}}});
  come_to_rest();
  library.centre_value = 1000.0;
  open("other");
  const Scene shown = rendered();
  EXPECT_EQ(shown.background.colour, glm::dvec3(1, 0, 0));
  EXPECT_EQ(shown.lens.cap, LensCap::open);
  EXPECT_NE(shown.lens.radius_mm, 5.0);
  EXPECT_NE(shown.camera.eye_mm.x, 900.0);
  EXPECT_EQ(shown.context.surface.band.lower, 900.0);
  EXPECT_EQ(shown.focus.surface.band.lower, 950.0);
}

TEST_F(SessionVolumeTest, WhatTheOpeningMessageSaysIsNotChosen) {
  viewport(640, 480);
  scene({{"volume", "ball"}, {"lens", {{"radius_mm", 7.0}}}});
  library.finish();
  strand->run();
  EXPECT_EQ(rendered().lens.radius_mm, 7.0);
}

TEST_F(SessionVolumeTest, ASceneThatMakesNoSenseFailsTheOpening) {
  show_ball();
  scene({{"volume", "other"}, {"camera", {{"eye_mm", {1, 2, 3}}, {"target_mm", {1, 2, 3}}}}});
  library.finish();
  strand->run();
  EXPECT_EQ(client.last("error")["code"], "invalid-scene");
  EXPECT_THAT(loading_stages(), ElementsAre("failed"));
  scene({{"lens", {{"radius_mm", 10.0}}}});
  EXPECT_EQ(rendered().volume, "ball");
}

}  // namespace
}  // namespace cutaway
