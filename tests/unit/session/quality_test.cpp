// How measured times become resolution, compression and frame rate.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "session/link_estimate.h"
#include "session/quality_control.h"
#include "session/step_control.h"

namespace cutaway {
namespace {

constexpr Milliseconds kBudget{33.0};

StepControl resolution_steps() {
  return StepControl({{1.0, 1.0}, {0.75, 0.5625}, {0.5, 0.25}, {0.25, 0.0625}}, kBudget, 1.0);
}

/// Frames whose cost is `fixed + full * scale^2`.
void run(StepControl& control, int frames, double fixed_ms, double full_ms) {
  for (int i = 0; i < frames; ++i) {
    control.observe(Milliseconds(fixed_ms + (full_ms * control.value() * control.value())));
  }
}

TEST(StepControl, StaysAtTheBestWhereThereIsRoom) {
  StepControl control = resolution_steps();
  run(control, 100, 0.0, 20.0);
  EXPECT_EQ(control.value(), 1.0);
}

TEST(StepControl, FallsToTheStepThatFits) {
  StepControl control = resolution_steps();
  run(control, 10, 0.0, 100.0);
  EXPECT_EQ(control.value(), 0.5);
}

TEST(StepControl, OneDearFrameAmongCheapOnesChangesNothing) {
  StepControl control = resolution_steps();
  run(control, 10, 0.0, 20.0);
  control.observe(Milliseconds(60.0));
  run(control, 10, 0.0, 20.0);
  EXPECT_EQ(control.value(), 1.0);
}

TEST(StepControl, ClimbsBackWhenThereIsRoomAgain) {
  StepControl control = resolution_steps();
  run(control, 10, 0.0, 500.0);
  EXPECT_EQ(control.value(), 0.25);
  run(control, 40, 0.0, 20.0);
  EXPECT_EQ(control.value(), 1.0);
}

TEST(StepControl, DoesNotSwingWhereTheBetterStepDoesNotFit) {
  StepControl control = resolution_steps();
  run(control, 20, 0.0, 70.0);  // 39 ms at 0.75, 17.5 ms at 0.5
  int changes = 0;
  double before = control.value();
  for (int i = 0; i < 500; ++i) {
    run(control, 1, 0.0, 70.0);
    if (control.value() != before) ++changes;
    before = control.value();
  }
  EXPECT_LE(changes, 10);  // trials, ever more seldom
}

TEST(StepControl, FindsTheBestStepThoughMostOfTheCostIsFixed) {
  StepControl control = resolution_steps();
  control.observe(Milliseconds(900.0));  // a first frame that compiles shaders
  EXPECT_EQ(control.value(), 0.25);
  run(control, 200, 20.0, 5.0);
  EXPECT_EQ(control.value(), 1.0);
}

TEST(StepControl, EndsAtTheLastStepHoweverDear) {
  StepControl control = resolution_steps();
  run(control, 50, 1000.0, 0.0);
  EXPECT_TRUE(control.at_last());
}

TEST(LinkEstimate, KnowsDistanceFromSlowness) {
  LinkEstimate distant;
  LinkEstimate slow;
  constexpr std::array kBytes = {20'000, 40'000, 90'000, 30'000, 60'000};
  for (int i = 0; i < 60; ++i) {
    const int bytes = kBytes[i % kBytes.size()];
    distant.acknowledged(bytes, Milliseconds(200.0));
    slow.acknowledged(bytes, Milliseconds(20.0 + (bytes * 0.008)));  // 1 Mbit/s
  }
  EXPECT_NEAR(distant.transfer_time(50'000).count(), 0.0, 1.0);
  EXPECT_NEAR(distant.latency().count(), 200.0, 5.0);
  EXPECT_NEAR(slow.transfer_time(50'000).count(), 400.0, 20.0);
  EXPECT_NEAR(slow.latency().count(), 20.0, 20.0);
}

TEST(LinkEstimate, FollowsALinkThatBecomesSlow) {
  LinkEstimate link;
  constexpr std::array kBytes = {20'000, 40'000, 60'000};
  for (int i = 0; i < 60; ++i) {
    const int bytes = kBytes[i % kBytes.size()];
    link.acknowledged(bytes, Milliseconds(10.0));
  }
  for (int i = 0; i < 60; ++i) {
    const int bytes = kBytes[i % kBytes.size()];
    link.acknowledged(bytes, Milliseconds(10.0 + (bytes * 0.008)));
  }
  EXPECT_NEAR(link.transfer_time(50'000).count(), 400.0, 40.0);
}

class QualityControlTest : public ::testing::Test {
 protected:
  /// Frames over a link, two in flight, bytes by the quality asked for.
  void stream(int frames, double ms_per_byte) {
    double bytes_before = 0.0;
    for (int i = 0; i < frames; ++i) {
      const FrameQuality asked = quality.interactive();
      const double bytes = 60'000.0 * asked.resolution_scale * asked.resolution_scale *
                           asked.jpeg_quality / 80.0 * (i % 3 == 0 ? 0.8 : 1.0);
      const double in_flight = bytes + (i % 2 == 0 ? 0.0 : bytes_before);
      quality.rendered(asked, Milliseconds(10.0));
      quality.acknowledged(asked, static_cast<std::size_t>(bytes),
                           static_cast<std::size_t>(in_flight),
                           Milliseconds(5.0 + (in_flight * ms_per_byte)));
      bytes_before = bytes;
    }
  }

  SessionSettings settings;
  QualityControl quality{settings};
};

TEST_F(QualityControlTest, BeginsAtFullResolution) {
  EXPECT_EQ(quality.interactive().resolution_scale, 1.0);
  EXPECT_EQ(quality.interactive().jpeg_quality, 80);
  EXPECT_FALSE(quality.interactive().still);
}

TEST(QualityControlSettings, SayWhereTheResolutionBegins) {
  const auto begins_at = [](double first) {
    SessionSettings settings;
    settings.first_resolution_scale = first;
    return QualityControl(settings).interactive().resolution_scale;
  };
  EXPECT_EQ(begins_at(0.5), 0.5);
  EXPECT_EQ(begins_at(0.6), 0.5);
  EXPECT_EQ(begins_at(0.2), 0.25);
}

TEST_F(QualityControlTest, ABeginningAtAHalfClimbsWhereThereIsRoom) {
  settings.first_resolution_scale = 0.5;
  QualityControl careful{settings};
  for (int i = 0; i < 40; ++i) careful.rendered(careful.interactive(), Milliseconds(1.0));
  EXPECT_EQ(careful.interactive().resolution_scale, 1.0);
}

TEST_F(QualityControlTest, StillIsFullResolutionSupersampledAtQuality92WithFullChroma) {
  quality.cast_rays(FrameQuality(), {640, 480}, Milliseconds(5.0));
  const FrameQuality still = quality.still({640, 480});
  EXPECT_EQ(still.resolution_scale, 1.0);
  EXPECT_EQ(still.supersampling, 2);
  EXPECT_EQ(still.jpeg_quality, 92);
  EXPECT_EQ(still.chroma, ChromaSampling::yuv444);
  EXPECT_TRUE(still.still);
}

TEST_F(QualityControlTest, AStillTooLargeForItsRaysGetsFewerAPixelButEveryPixel) {
  quality.cast_rays(FrameQuality(), {640, 480}, Milliseconds(5.0));
  EXPECT_EQ(quality.still({1920, 1080}).supersampling, 2);
  EXPECT_EQ(quality.still({3840, 2160}).supersampling, 1);
  EXPECT_EQ(quality.still({3840, 2160}).resolution_scale, 1.0);
}

TEST_F(QualityControlTest, AStillThatWouldTakeTooLongGetsFewerRaysAPixelButEveryPixel) {
  constexpr Viewport kViewport{640, 480};
  FrameQuality moving;
  moving.resolution_scale = 0.5;
  quality.cast_rays(moving, kViewport, Milliseconds(5000.0));
  EXPECT_EQ(quality.still(kViewport).supersampling, 1) << "the first says how much at the most";
  quality.cast_rays(moving, kViewport, Milliseconds(30.0));  // 480 ms with four rays a pixel
  EXPECT_EQ(quality.still(kViewport).supersampling, 2);
  EXPECT_EQ(quality.still({1280, 960}).supersampling, 1);  // of a window that has grown since
  for (int i = 0; i < 20; ++i) quality.cast_rays(moving, kViewport, Milliseconds(32.0));
  EXPECT_EQ(quality.still(kViewport).supersampling, 1);
  EXPECT_EQ(quality.still(kViewport).resolution_scale, 1.0);
  FrameQuality still = quality.still(kViewport);
  still.supersampling = 2;
  for (int i = 0; i < 20; ++i) quality.cast_rays(still, kViewport, Milliseconds(400.0));
  EXPECT_EQ(quality.still(kViewport).supersampling, 2);
}

TEST_F(QualityControlTest, NothingIsSpentOnAStillBeforeItsCostIsKnown) {
  EXPECT_EQ(quality.still({640, 480}).supersampling, 1);
  EXPECT_EQ(quality.still({640, 480, ViewKind::axial}).supersampling, 2) << "it casts no rays";
}

TEST_F(QualityControlTest, AFirstFrameThatFitsWithAllItMakesIsEnough) {
  quality.cast_rays(FrameQuality(), {640, 480}, Milliseconds(120.0));
  EXPECT_EQ(quality.still({640, 480}).supersampling, 2);
}

TEST_F(QualityControlTest, AnotherVolumesRaysAreForgotten) {
  for (int i = 0; i < 3; ++i) quality.cast_rays(FrameQuality(), {640, 480}, Milliseconds(10.0));
  EXPECT_EQ(quality.still({640, 480}).supersampling, 2);
  quality.forget_rays();
  EXPECT_EQ(quality.still({640, 480}).supersampling, 1);
  quality.cast_rays(FrameQuality(), {640, 480}, Milliseconds(200.0));
  EXPECT_EQ(quality.still({640, 480}).supersampling, 1);
}

// What a frame costs beside its rays would count as the cost of a few.
TEST_F(QualityControlTest, AFrameOfAFewRaysSaysLittle) {
  const Viewport viewport{640, 480};
  for (int i = 0; i < 5; ++i) quality.cast_rays(FrameQuality(), {1, 1}, Milliseconds(20.0));
  quality.cast_rays(FrameQuality(), viewport, Milliseconds(50.0));
  EXPECT_EQ(quality.still(viewport).supersampling, 2);
}

TEST_F(QualityControlTest, SlowRenderingLowersResolutionOnly) {
  for (int i = 0; i < 20; ++i) {
    const FrameQuality asked = quality.interactive();
    quality.rendered(asked, Milliseconds(150.0 * asked.resolution_scale * asked.resolution_scale));
  }
  EXPECT_LT(quality.interactive().resolution_scale, 0.6);
  EXPECT_EQ(quality.interactive().jpeg_quality, 80);
}

TEST_F(QualityControlTest, AStillFrameDoesNotCountAsInteractive) {
  for (int i = 0; i < 20; ++i) quality.rendered(quality.still({640, 480}), Milliseconds(2000.0));
  EXPECT_EQ(quality.interactive().resolution_scale, 1.0);
}

TEST_F(QualityControlTest, AFastLinkKeepsQualityAndRate) {
  stream(200, 0.00001);
  EXPECT_EQ(quality.interactive().jpeg_quality, 80);
  EXPECT_EQ(quality.interval().count(), 0.0);
}

TEST_F(QualityControlTest, ASlowerLinkLowersJpegQualityFirst) {
  stream(200, 0.001);  // 60 kB in 60 ms
  EXPECT_LT(quality.interactive().jpeg_quality, 80);
  EXPECT_EQ(quality.interactive().resolution_scale, 1.0);
}

TEST_F(QualityControlTest, AVerySlowLinkLowersResolutionAndRateToo) {
  stream(300, 0.1);  // 80 kbit/s
  EXPECT_EQ(quality.interactive().jpeg_quality, 25);
  EXPECT_LT(quality.interactive().resolution_scale, 0.6);
  EXPECT_GT(quality.interval().count(), 33.0);
}

}  // namespace
}  // namespace cutaway
