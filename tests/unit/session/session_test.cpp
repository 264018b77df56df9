// A session from its first message on: scene, viewport, lens, picking, stills.
#include <gmock/gmock.h>

#include "scene/view_geometry.h"
#include "unit/session/session_fixture.h"

namespace cutaway {
namespace {

using SessionTest = testing::SessionFixture;

TEST_F(SessionTest, BeginsWithCapabilitiesAndVolumes) {
  ASSERT_EQ(client.texts.size(), 2);
  EXPECT_EQ(client.texts[0]["type"], "capabilities");
  EXPECT_EQ(client.texts[1]["type"], "volumes");
}

TEST_F(SessionTest, TellsOfAListingThatChanges) {
  library.change_listing({{"volumes", {{{"id", "new"}}}}, {"refused", Json::array()}});
  strand->run();
  EXPECT_EQ(client.last("volumes")["volumes"][0]["id"], "new");
}

TEST_F(SessionTest, SendsNoFrameBeforeVolumeAndViewport) {
  open("ball");
  EXPECT_TRUE(frames.idle());
  EXPECT_TRUE(client.last("scene").is_null());
  viewport(640, 480);
  EXPECT_FALSE(frames.idle());
  EXPECT_EQ(client.last("scene")["scene"]["volume"], "ball");
}

TEST_F(SessionTest, ChoosesWhatTheSceneLeavesOpenAndSaysSo) {
  viewport(640, 480);
  open("ball");
  ASSERT_EQ(client.of_type("scene").size(), 1);
  const Json message = client.last("scene");
  EXPECT_EQ(message["scene"]["context"]["surface"]["iso_value"], 100.0);
  EXPECT_EQ(message["scene"]["focus"]["surface"]["iso_value"], 150.0);
  EXPECT_TRUE(message["scene"]["camera"].contains("eye_mm"));
  EXPECT_EQ(message["volume"]["id"], "ball");
}

TEST_F(SessionTest, FramesCarryTheInputAndRevisionTheyShow) {
  show_ball();
  const std::uint32_t latest = scene({{"focus", {{"surface", {{"iso_value", 120.0}}}}}});
  EXPECT_EQ(rendered().focus.surface.band.lower, 120.0);
  EXPECT_EQ(client.frames.back().header.input, latest);
}

TEST_F(SessionTest, DoesNotRepeatToTheClientWhatItSpeltOutItself) {
  show_ball();
  scene({{"focus", {{"surface", {{"iso_value", 120.0}}}}}});
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(client.of_type("scene").empty());
}

TEST_F(SessionTest, ACameraThatIsOnlyBroughtIntoFormIsNotRepeatedEither) {
  show_ball();
  scene({{"camera", {{"eye_mm", {300, -400, 100}}, {"up", {0, 0.1, 5}}}}});
  scene({{"camera", {{"eye_mm", {310, -400, 100}}}}});
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(client.of_type("scene").empty());
}

TEST_F(SessionTest, ANullTakesAFieldBackToItsDefaultAndTheClientIsTold) {
  show_ball();
  scene({{"focus", {{"surface", {{"iso_value", 120.0}}}}}});
  scene({{"focus", {{"surface", {{"iso_value", nullptr}}}}}});
  strand->advance(Milliseconds(100.0));
  EXPECT_EQ(client.last("scene")["scene"]["focus"]["surface"]["iso_value"], 150.0);
}

TEST_F(SessionTest, AReplacingSceneKeepsOnlyTheVolume) {
  show_ball();
  scene({{"light", {{"frame", "patient"}}}, {"camera", {{"vertical_fov_degrees", 60}}}});
  scene({{"light", {{"direction", {0, 0, 1}}}}}, true);
  come_to_rest();
  const Json document = client.last("scene")["scene"];
  EXPECT_EQ(document["volume"], "ball");
  EXPECT_EQ(document["light"]["frame"], "camera");
  EXPECT_EQ(document["camera"]["vertical_fov_degrees"], 30.0);
}

TEST_F(SessionTest, WhatWasChosenStaysWhenTheCameraTurns) {
  show_ball();
  scene({{"lens", {{"radius_mm", 10.0}}}});
  const glm::dvec3 before = rendered().lens.centre_mm;
  scene({{"camera", {{"eye_mm", {500, 0, 0}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}}}});
  EXPECT_EQ(rendered().lens.centre_mm, before);
}

TEST_F(SessionTest, AMessageThatChangesNothingMakesNoFrame) {
  show_ball();
  scene(Json::object());
  viewport(640, 480);
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(frames.idle());
}

TEST_F(SessionTest, WhoWaitsForAPictureOfWhatChangesNothingHearsThatItIsThere) {
  show_ball();
  scene({{"lens", {{"radius_mm", 10.0}}}});
  settle();
  EXPECT_TRUE(client.of_type("scene").empty());
  const std::uint32_t latest = scene({{"lens", {{"radius_mm", 10.0}}}});
  strand->advance(Milliseconds(1000.0));
  EXPECT_EQ(client.last("scene")["input"], latest);
  EXPECT_EQ(client.last("scene")["revision"], client.frames.back().header.revision);
  const std::size_t told = client.of_type("scene").size();
  scene({{"slices", {{"convention", "neurological"}}}});
  strand->advance(Milliseconds(1000.0));
  EXPECT_EQ(client.of_type("scene").size(), told) << "no 3-D picture is awaited of that";
}

TEST_F(SessionTest, WhoWaitsForAPictureOfTheSameViewportHearsThatItIsThere) {
  show_ball();
  settle();
  strand->advance(Milliseconds(1000.0));
  const std::uint32_t latest = viewport(640, 480);
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(frames.idle());
  EXPECT_EQ(client.last("scene")["input"], latest);
}

TEST_F(SessionTest, TheNextFrameShowsTheInputThatChangedNothing) {
  show_ball();
  scene(Json::object());
  const std::uint32_t latest = scene({{"lens", {{"radius_mm", 10.0}}}});
  settle();
  EXPECT_EQ(client.frames.back().header.input, latest);
}

TEST_F(SessionTest, AViewportOfOnePixelIsFine) {
  show_ball();
  viewport(1, 1);
  EXPECT_EQ(rendered().viewport, (Viewport{1, 1}));
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionTest, DragLensPutsItOnTheContextAndTellsTheClient) {
  show_ball();
  receive(
      {{"type", "drag_lens"}, {"input", ++input}, {"clock_ms", 1.0}, {"position_px", {350, 240}}});
  const Scene shown = rendered();
  EXPECT_NEAR(glm::length(shown.lens.centre_mm), 100.0, 0.5);
  const auto at_px = project_px(shown.camera, shown.viewport, shown.lens.centre_mm);
  ASSERT_TRUE(at_px.has_value());
  EXPECT_LT(glm::distance(*at_px, glm::dvec2(350.0, 240.0)), 0.1);
  const Json centre = client.last("scene")["scene"]["lens"]["centre_mm"];
  EXPECT_NEAR(centre[0].get<double>(), shown.lens.centre_mm.x, 1e-6);
}

TEST_F(SessionTest, AStormOfDragsTellsTheSceneSeldomAndTheLastOneSurely) {
  show_ball();
  for (int i = 0; i < 60; ++i) {
    receive({{"type", "drag_lens"},
             {"input", ++input},
             {"clock_ms", 1.0},
             {"position_px", {300 + i, 240}}});
    strand->advance(Milliseconds(5.0));
  }
  come_to_rest();
  const auto told = client.of_type("scene");
  EXPECT_LT(told.size(), 12);
  for (const Json& message : told) EXPECT_FALSE(message.contains("volume"));
  EXPECT_EQ(client.last("scene")["revision"], client.frames.back().header.revision);
}

TEST_F(SessionTest, PickSaysWhatIsThere) {
  show_ball();
  scene({{"lens", {{"mode", "none"}}}});
  receive({{"type", "pick"}, {"request", 5}, {"position_px", {320, 240}}});
  const Json picked = client.last("picked");
  EXPECT_EQ(picked["request"], 5);
  EXPECT_EQ(picked["branch"], "context");
  EXPECT_EQ(picked["units"], "HU");
  EXPECT_NEAR(picked["value"].get<double>(), 100.0, 1.0);
}

TEST_F(SessionTest, PickBesideTheVolumeHasNoPosition) {
  show_ball();
  receive({{"type", "pick"}, {"request", 6}, {"position_px", {0, 0}}});
  EXPECT_EQ(client.last("picked"), Json({{"type", "picked"}, {"request", 6}}));
}

TEST_F(SessionTest, SaveStillComesAsALosslessPictureOfItsOwnSize) {
  show_ball();
  receive({{"type", "save_still"}, {"request", 42}, {"width_px", 1920}, {"height_px", 1080}});
  const FrameRequest request = frames.finish();
  strand->run();
  EXPECT_EQ(frames.stills_submitted, 1);
  EXPECT_EQ(request.view, 2);
  EXPECT_EQ(request.scene->viewport, (Viewport{1920, 1080}));
  ASSERT_EQ(client.stills.size(), 1);
  const FrameHeader& header = client.stills[0].header;
  EXPECT_EQ(header.type, PictureType::saved_still);
  EXPECT_TRUE(header.lossless);
  EXPECT_EQ(header.frame, 42);
  EXPECT_EQ(header.picture_width_px, 1920);
  EXPECT_TRUE(frames.released.contains(2));
}

Json save(std::uint32_t request) {
  return {{"type", "save_still"}, {"request", request}, {"width_px", 64}, {"height_px", 64}};
}

// A client has all bytes of a still before the server hears that they are written.
TEST_F(SessionTest, AClientThatHasItsStillMayAskForTheNext) {
  show_ball();
  for (std::uint32_t request = 1; request < 5; ++request) {
    receive(save(request));
    if (request > 1) client.stills.back().done(true);
    strand->run();
    frames.finish();
    strand->run();
    ASSERT_EQ(client.stills.size(), request);
    EXPECT_EQ(client.stills.back().header.frame, request);
  }
  EXPECT_TRUE(client.of_type("error").empty());
}

// A film has two requests on their way at all times.
TEST_F(SessionTest, AClientThatHasItsStillMayAskAnewThoughAnotherWaits) {
  show_ball();
  receive(save(1));
  receive(save(2));
  for (std::uint32_t request = 1; request < 5; ++request) {
    frames.finish();
    strand->run();
    ASSERT_EQ(client.stills.size(), request);
    receive(save(request + 2));
    client.stills.back().done(true);
    strand->run();
  }
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionTest, NoMoreThanTwoStillsWaitBesideTheOneThatIsWritten) {
  show_ball();
  receive(save(1));
  frames.finish();
  strand->run();
  for (std::uint32_t request = 2; request < 5; ++request) receive(save(request));
  expect_error("rate-limited");
  EXPECT_EQ(client.last("error")["request"], 4);
  EXPECT_TRUE(frames.idle()) << "the second was made while the first was being sent";
}

TEST_F(SessionTest, OneStillIsMadeAndOneWaits) {
  show_ball();
  for (std::uint32_t request = 1; request < 4; ++request) receive(save(request));
  expect_error("rate-limited");
  EXPECT_EQ(client.last("error")["request"], 3);
  frames.finish();
  strand->run();
  EXPECT_TRUE(frames.idle()) << "the second was made while the first was being sent";
  client.stills[0].done(true);
  strand->run();
  frames.finish();
  strand->run();
  ASSERT_EQ(client.stills.size(), 2);
  EXPECT_EQ(client.stills[1].header.frame, 2);
  EXPECT_EQ(client.of_type("error").size(), 1);
}

TEST_F(SessionTest, AStillThatFailsMakesWayForTheOneThatWaits) {
  show_ball();
  receive(save(1));
  receive(save(2));
  frames.fail(Error({.code = ErrorCode::render_failed, .message = "no"}));
  strand->run();
  EXPECT_EQ(client.last("error")["request"], 1);
  frames.finish();
  strand->run();
  ASSERT_EQ(client.stills.size(), 1);
  EXPECT_EQ(client.stills[0].header.frame, 2);
}

TEST_F(SessionTest, LiveFramesGoOnWhileAStillIsMade) {
  show_ball();
  receive({{"type", "save_still"}, {"request", 1}, {"width_px", 64}, {"height_px", 64}});
  frames.begin();
  scene({{"lens", {{"radius_mm", 10.0}}}});
  EXPECT_EQ(frames.waiting(), 1);
}

TEST_F(SessionTest, TellsTheSceneWhenABandLosesItsUpperEnd) {
  show_ball();
  scene({{"focus", {{"surface", {{"upper_value", 400.0}}}}}});
  EXPECT_TRUE(client.of_type("scene").empty()) << "the client spelled it out";
  strand->advance(Milliseconds(1000.0));
  scene({{"focus", {{"surface", {{"upper_value", nullptr}}}}}});
  strand->advance(Milliseconds(1000.0));
  ASSERT_FALSE(client.of_type("scene").empty());
  EXPECT_FALSE(client.last("scene")["scene"]["focus"]["surface"].contains("upper_value"));
}

Json preview(std::uint32_t request, const char* style) {
  return {{"type", "preview"},
          {"request", request},
          {"style", style},
          {"width_px", 120},
          {"height_px", 90}};
}

TEST_F(SessionTest, APreviewIsTheSceneInAnotherStyleWhichIsNotTakenUp) {
  show_ball();
  scene({{"lens", {{"radius_mm", 17.0}}}});
  come_to_rest();
  receive(preview(7, "toon"));
  const FrameRequest request = frames.finish();
  strand->run();
  EXPECT_EQ(request.view, 3);
  EXPECT_EQ(request.scene->viewport, (Viewport{120, 90}));
  EXPECT_EQ(request.scene->lens.radius_mm, 17.0);
  EXPECT_EQ(request.scene->focus.shading.parameters.at("detail"), 0);
  ASSERT_EQ(client.stills.size(), 1);
  EXPECT_EQ(client.stills[0].header.type, PictureType::preview);
  EXPECT_EQ(client.stills[0].header.frame, 7);
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(frames.idle()) << "the scene itself has not changed";
}

TEST_F(SessionTest, EachPictureIsAskedForInTheSessionsName) {
  show_ball();
  scene({{"lens", {{"radius_mm", 17.0}}}});
  EXPECT_EQ(frames.finish().session, testing::kSessionName);
  come_to_rest();
  receive(save(1));
  EXPECT_EQ(frames.finish().session, testing::kSessionName);
  strand->run();
  receive(preview(2, "toon"));
  EXPECT_EQ(frames.finish().session, testing::kSessionName);
}

TEST_F(SessionTest, PreviewsAreMadeOneAfterTheOther) {
  show_ball();
  receive(preview(1, "flagship"));
  receive(preview(2, "toon"));
  EXPECT_EQ(frames.waiting(), 1);
  for (const std::size_t made : {1U, 2U}) {
    frames.finish();
    strand->run();
    ASSERT_EQ(client.stills.size(), made);
    client.stills.back().done(true);
    strand->run();
  }
  EXPECT_TRUE(frames.released.contains(3));
}

TEST_F(SessionTest, PreviewsThatCannotBeMadeAreRefusedWithTheirRequest) {
  receive(preview(3, "flagship"));
  expect_error("no-volume");
  EXPECT_EQ(client.last("error")["request"], 3);
  show_ball();
  receive(preview(4, "watercolour"));
  expect_error("unknown-style", "/style");
  EXPECT_EQ(client.last("error")["request"], 4);
  for (std::uint32_t i = 0; i < 66; ++i) receive(preview(100 + i, "toon"));
  expect_error("rate-limited");
}

TEST_F(SessionTest, EndsLeavingNothingBehind) {
  show_ball();
  scene({{"volume", "other"}});
  session.reset();
  EXPECT_TRUE(library.wishes.back()->withdrawn);
  EXPECT_TRUE(frames.released.contains(1));
  EXPECT_FALSE(strand->has_alarm());
  library.finish();
  strand->run();
}

}  // namespace
}  // namespace cutaway
