// The slices of a session beside its 3-D picture: one scene, one link, frames of their own.
#include "unit/session/session_fixture.h"

namespace cutaway::testing {
namespace {

constexpr std::uint64_t kAxialView = 4;  // as in the fixture

class SessionViewsTest : public SessionFixture {
 protected:
  void slice_viewport(int view, int width_px = 100, int height_px = 80) {
    receive({{"type", "viewport"},
             {"view", view},
             {"input", ++input},
             {"clock_ms", 1.0},
             {"width_px", width_px},
             {"height_px", height_px}});
  }
  void acknowledge(const FrameHeader& header) {
    receive({{"type", "ack"}, {"view", header.view}, {"frame", header.frame}});
  }
  /// Renders and acknowledges all that is asked for, stills included.
  void rest() {
    do {
      while (!frames.idle()) {
        frames.finish();
        strand->run();
        acknowledge(client.frames.back().header);
      }
      strand->advance(Milliseconds(300.0));
    } while (!frames.idle());
  }
  void show_slices() {
    show_ball();
    for (const int view : {1, 2, 3}) slice_viewport(view);
    rest();
    client.frames.clear();
    client.texts.clear();
  }
  /// Both of the axial view's credits are out then.
  void leave_two_axial_frames_unacknowledged() {
    for (int z = 1; z <= 2; ++z) {
      scene({{"slices", {{"crosshair_mm", {0, 0, z}}}}});
      frames.begin();
      frames.finish();
      strand->run();
    }
  }
  std::vector<std::uint16_t> views_sent() {
    std::set<std::uint16_t> views;
    for (const auto& frame : client.frames) views.insert(frame.header.view);
    return {views.begin(), views.end()};
  }
};

using Views = std::vector<std::uint16_t>;

TEST_F(SessionViewsTest, ASliceIsAViewportOfTheSameScene) {
  show_ball();
  slice_viewport(1);
  const FrameRequest request = frames.finish();
  strand->run();
  EXPECT_EQ(request.view, kAxialView);
  EXPECT_EQ(request.scene->viewport, (Viewport{100, 80, ViewKind::axial}));
  EXPECT_EQ(request.scene->volume, "ball");
  ASSERT_EQ(client.frames.size(), 1);
  EXPECT_EQ(client.frames[0].header.view, 1);
  EXPECT_EQ(client.frames[0].header.frame, 1) << "each view counts its own";
  acknowledge(client.frames[0].header);
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionViewsTest, TheCrosshairCostsThe3DPictureNothing) {
  show_slices();
  scene({{"slices", {{"crosshair_mm", {0, 0, 12}}}}});
  rest();
  EXPECT_EQ(views_sent(), Views{1}) << "it moved along the axial slice's normal";
}

TEST_F(SessionViewsTest, WhatMovesIn3DCostsNoSlice) {
  show_slices();
  scene({{"camera", {{"eye_mm", {0, -700, 50}}}}});
  rest();
  EXPECT_EQ(views_sent(), Views{0});
}

TEST_F(SessionViewsTest, AWindowIsOfAllSlices) {
  show_slices();
  scene({{"slices", {{"window", {{"centre", 400}, {"width", 1800}}}}}});
  rest();
  EXPECT_EQ(views_sent(), (Views{1, 2, 3}));
}

TEST_F(SessionViewsTest, EachViewHasCreditsOfItsOwn) {
  show_slices();
  leave_two_axial_frames_unacknowledged();
  scene({{"slices", {{"crosshair_mm", {0, 0, 3}}}}});
  EXPECT_TRUE(frames.idle()) << "the axial view's two credits are out";
  scene({{"camera", {{"eye_mm", {0, -700, 50}}}}});
  EXPECT_FALSE(frames.idle());
}

TEST_F(SessionViewsTest, AClosedViewGetsNoMoreFramesAndIsFreed) {
  show_slices();
  receive({{"type", "close_view"}, {"view", 1}});
  EXPECT_TRUE(frames.released.contains(kAxialView));
  scene({{"slices", {{"crosshair_mm", {3, 3, 3}}}}});
  rest();
  EXPECT_EQ(views_sent(), (Views{2, 3}));
}

TEST_F(SessionViewsTest, AClosedViewHasItsCreditsBackThoughNobodyAcknowledges) {
  show_slices();
  leave_two_axial_frames_unacknowledged();
  receive({{"type", "close_view"}, {"view", 1}});
  slice_viewport(1);
  EXPECT_FALSE(frames.idle());
  acknowledge(client.frames[0].header);  // on its way when the view was closed
  EXPECT_TRUE(client.of_type("error").empty());
}

/// But never with what the user needs for the next click.
TEST_F(SessionViewsTest, APicturesLensIsPaidForWithHalfOfTheBurstAtMost) {
  settings.lens_search_messages = 5000.0;
  restart();
  show_ball();
  strand->advance(Milliseconds(60'000.0));  // in which the first lens is paid for
  client.texts.clear();
  const Json patch{{"lens", {{"centre_mm", nullptr}}}};
  receive({{"type", "save_still"},
           {"request", 8},
           {"width_px", 60},
           {"height_px", 50},
           {"scene", patch}});
  const int half = static_cast<int>(settings.messages.burst / 2.0);
  for (int i = 0; i < half - 1; ++i) scene({{"lens", {{"radius_mm", 12.0}}}});
  EXPECT_TRUE(client.of_type("error").empty());
  for (int i = 0; i < 2; ++i) scene({{"lens", {{"radius_mm", 12.0}}}});
  expect_error("rate-limited");
}

TEST_F(SessionViewsTest, AViewOpenedAgainGoesOnCounting) {
  show_slices();
  receive({{"type", "close_view"}, {"view", 1}});
  slice_viewport(1);
  frames.finish();
  strand->run();
  ASSERT_EQ(client.frames.size(), 1);
  EXPECT_GT(client.frames[0].header.frame, 1U);
  acknowledge(client.frames[0].header);
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionViewsTest, AFrameThatComesAfterItsViewWasClosedIsDropped) {
  show_slices();
  scene({{"slices", {{"crosshair_mm", {0, 0, 5}}}}});
  frames.begin();
  receive({{"type", "close_view"}, {"view", 1}});
  frames.finish();
  strand->run();
  EXPECT_TRUE(client.frames.empty());
}

TEST_F(SessionViewsTest, APickOnASliceIsThePlanesPointAndValue) {
  show_slices();
  scene({{"slices",
          {{"crosshair_mm", {0, 0, 30}},
           {"axial", {{"centre_mm", {0, 0, 0}}, {"view_height_mm", 80}}}}}});
  receive({{"type", "pick"}, {"view", 1}, {"request", 5}, {"position_px", {90, 40}}});
  const Json picked = client.last("picked");
  EXPECT_EQ(picked["position_mm"], Json::parse("[40.0, 0.0, 30.0]"));
  EXPECT_NEAR(picked["value"].get<double>(), 200.0 - 50.0, 1e-9);
  EXPECT_FALSE(picked.contains("branch"));
  receive({{"type", "pick"}, {"view", 1}, {"request", 6}, {"position_px", {5000, 40}}});
  EXPECT_FALSE(client.last("picked").contains("position_mm"));
}

TEST_F(SessionViewsTest, APickOnASliceThatIsNotShownIsRefused) {
  show_ball();
  receive({{"type", "pick"}, {"view", 2}, {"request", 5}, {"position_px", {1, 1}}});
  expect_error("no-volume");
}

TEST_F(SessionViewsTest, AStillOfASliceAndOfAChangedScene) {
  show_slices();
  receive({{"type", "save_still"},
           {"view", 3},
           {"request", 8},
           {"width_px", 600},
           {"height_px", 500},
           {"scene", {{"slices", {{"window", {{"width", 80}}}}}}}});
  const FrameRequest request = frames.finish();
  strand->run();
  EXPECT_EQ(request.scene->viewport, (Viewport{600, 500, ViewKind::sagittal}));
  EXPECT_EQ(request.scene->slices.window.width, 80.0);
  ASSERT_EQ(client.stills.size(), 1);
  EXPECT_EQ(client.stills[0].header.view, 3);
  strand->advance(Milliseconds(1000.0));
  EXPECT_TRUE(frames.idle()) << "the session has not taken the change up";
}

TEST_F(SessionViewsTest, AStillsPatchCannotNameAVolume) {
  show_slices();
  receive({{"type", "save_still"},
           {"request", 8},
           {"width_px", 60},
           {"height_px", 50},
           {"scene", {{"volume", "another"}}}});
  expect_error("invalid-scene", "/volume");
}

Json preview_of(std::uint32_t request, const char* volume) {
  return {{"type", "preview"},
          {"request", request},
          {"volume", volume},
          {"width_px", 96},
          {"height_px", 96}};
}

TEST_F(SessionViewsTest, APreviewOfAnotherVolumeOpensItForThatPictureOnly) {
  show_ball();
  receive(preview_of(4, "other"));
  EXPECT_TRUE(frames.idle()) << "it is on its way";
  library.finish();
  strand->run();
  const FrameRequest request = frames.finish();
  strand->run();
  EXPECT_EQ(request.scene->volume, "other");
  ASSERT_EQ(client.stills.size(), 1);
  EXPECT_EQ(client.stills[0].header.frame, 4);
  EXPECT_TRUE(client.of_type("loading").empty());
  EXPECT_TRUE(client.of_type("scene").empty());
}

TEST_F(SessionViewsTest, APictureOfAVolumeIsMadeOnceForAll) {
  show_ball();
  receive(preview_of(4, "other"));
  library.finish();
  strand->run();
  frames.finish();
  strand->run();
  client.stills.back().done(true);
  strand->run();
  const std::size_t opened = library.wishes.size();
  receive(preview_of(5, "other"));
  EXPECT_EQ(library.wishes.size(), opened);
  ASSERT_EQ(client.stills.size(), 2);
  EXPECT_EQ(client.stills[1].header.frame, 5);
  EXPECT_EQ(client.stills[1].header.revision, 0U) << "of no session's scene";
}

TEST_F(SessionViewsTest, AVolumeThatIsLongInComingKeepsNoStyleWaiting) {
  show_ball();
  receive(preview_of(4, "other"));
  receive({{"type", "preview"},
           {"request", 5},
           {"style", "toon"},
           {"width_px", 96},
           {"height_px", 96}});
  EXPECT_FALSE(frames.idle());
}

TEST(PreviewCache, KeepsWhatWasAskedForLast) {
  PreviewCache cache(250);
  const auto picture = [] {
    return std::make_shared<const Frame>(
        Frame{.picture = {{10, 10}, std::vector<std::uint8_t>(100)}});
  };
  cache.put("a", picture());
  cache.put("b", picture());
  EXPECT_NE(cache.find("a"), nullptr);
  cache.put("c", picture());
  EXPECT_EQ(cache.find("b"), nullptr);
  EXPECT_NE(cache.find("a"), nullptr);
}

TEST_F(SessionViewsTest, APreviewOfAVolumeThatCannotBeOpenedIsAnsweredWithItsRequest) {
  show_ball();
  receive(preview_of(4, "other"));
  library.fail(
      Error({.code = ErrorCode::volume_refused, .message = "it is broken", .field = "/volume"}));
  strand->run();
  expect_error("volume-refused", "/volume");
  EXPECT_EQ(client.last("error")["request"], 4);
  receive(preview_of(5, "other"));
  EXPECT_GT(library.wishes.size(), 2U) << "the next one is tried";
}

TEST_F(SessionViewsTest, APreviewOfTheSceneChangedByAPatch) {
  show_ball();
  receive({{"type", "preview"},
           {"request", 6},
           {"scene", {{"lens", {{"mode", "none"}}}}},
           {"width_px", 96},
           {"height_px", 96}});
  EXPECT_EQ(frames.finish().scene->lens.mode, LensMode::none);
}

}  // namespace
}  // namespace cutaway::testing
