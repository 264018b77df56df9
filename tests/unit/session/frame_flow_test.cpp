// Credits, latest-wins, quality and silence, between a frame source and a client that the test
// holds in its hands.
#include "session/frame_flow.h"

#include <gtest/gtest.h>

#include "unit/session/fake_strand.h"
#include "unit/session/fakes.h"

namespace cutaway {
namespace {

using testing::FakeClient;
using testing::FakeFrames;
using testing::FakeStrand;

constexpr std::uint64_t kView = 7;

class FrameFlowTest : public ::testing::Test {
 protected:
  void show(std::uint32_t revision) {
    auto scene = std::make_shared<Scene>();
    scene->viewport = {640, 480};
    flow->show({scene, revision, {revision * 10, revision * 1.5}});
  }
  FrameRequest finish(std::uint32_t render_us = 5000) {
    FrameRequest request = frames.finish(render_us);
    strand->run();
    return request;
  }
  void acknowledge_all() {
    flow->acknowledge(client.frames.back().header.frame);
    strand->run();
  }

  std::shared_ptr<FakeStrand> strand = std::make_shared<FakeStrand>();
  FakeFrames frames;
  FakeClient client;
  LinkLoad link;
  std::vector<Error> errors;
  SessionSettings settings;
  std::unique_ptr<FrameFlow> flow =
      std::make_unique<FrameFlow>(strand, ViewWiring{frames, client, link, {kView}}, settings,
                                  [this](const Error& error) { errors.push_back(error); });
};

TEST_F(FrameFlowTest, SendsWhatItWasAskedToShow) {
  show(1);
  finish();
  ASSERT_EQ(client.frames.size(), 1);
  const FrameHeader& header = client.frames[0].header;
  EXPECT_EQ(header.type, PictureType::live_frame);
  EXPECT_EQ(header.frame, 1);
  EXPECT_EQ(header.revision, 1);
  EXPECT_EQ(header.input, 10);
  EXPECT_EQ(header.clock_ms, 1.5);
  EXPECT_EQ(header.render_us, 5000);
  EXPECT_EQ(header.encode_us, 1000);
  EXPECT_EQ(header.viewport_width_px, 640);
  EXPECT_EQ(header.viewport_height_px, 480);
  EXPECT_EQ(header.picture_bytes, 100);
  EXPECT_FALSE(header.still_quality);
}

// The budget of 500 ms was ignored while nothing was known: 1366 ms for the first still.
TEST_F(FrameFlowTest, TheFirstStillWaitsUntilItIsKnownWhatRaysCost) {
  show(1);
  frames.begin();
  strand->advance(Milliseconds(300.0));
  EXPECT_EQ(frames.submitted, 1);
  finish(300'000);
  EXPECT_EQ(frames.submitted, 2);
  const FrameRequest still = finish();
  EXPECT_TRUE(still.quality.still);
  EXPECT_EQ(still.quality.supersampling, 1);
}

TEST_F(FrameFlowTest, TheFirstStillOfAnotherVolumeKeepsItsBudgetToo) {
  show(1);
  finish();
  auto scene = std::make_shared<Scene>();
  scene->volume = "another";
  scene->viewport = {640, 480};
  flow->show({scene, 2, {}});
  finish(300'000);
  strand->advance(Milliseconds(300.0));
  acknowledge_all();
  const FrameRequest still = finish();
  EXPECT_TRUE(still.quality.still);
  EXPECT_EQ(still.quality.supersampling, 1);
}

TEST_F(FrameFlowTest, TenInputsDuringAFrameBecomeOneFrameOfTheNewest) {
  show(1);
  frames.begin();
  for (std::uint32_t revision = 2; revision <= 11; ++revision) show(revision);
  EXPECT_EQ(frames.submitted, 2);
  EXPECT_EQ(finish().revision, 1);
  EXPECT_EQ(frames.begin().revision, 11);
  finish();
  ASSERT_EQ(client.frames.size(), 2);
  EXPECT_EQ(client.frames[1].header.revision, 11);
  EXPECT_EQ(client.frames[1].header.input, 110);
  EXPECT_TRUE(frames.idle());
}

TEST_F(FrameFlowTest, HasTwoFramesInFlightAtMost) {
  show(1);
  frames.begin();
  show(2);
  frames.begin();
  show(3);
  EXPECT_EQ(frames.submitted, 2);
  finish();
  finish();
  EXPECT_EQ(frames.submitted, 2) << "sent is not acknowledged";
  flow->acknowledge(1);
  EXPECT_EQ(frames.submitted, 3);
  EXPECT_EQ(frames.begin().revision, 3);
}

TEST_F(FrameFlowTest, AFrameThatANewerHasOvertakenIsNotSentAndReturnsItsCredit) {
  show(1);
  frames.begin();
  show(2);
  frames.begin();
  frames.overtake();
  EXPECT_EQ(finish().revision, 2);
  EXPECT_EQ(finish().revision, 1);
  ASSERT_EQ(client.frames.size(), 1);
  EXPECT_EQ(client.frames[0].header.revision, 2);
  show(3);
  EXPECT_EQ(frames.submitted, 3) << "one is on its way, one credit is free";
}

TEST_F(FrameFlowTest, RendersNothingForAClientThatNeverAcknowledges) {
  for (std::uint32_t revision = 1; revision <= 50; ++revision) {
    show(revision);
    while (!frames.idle()) finish();
    strand->advance(Milliseconds(50.0));
  }
  EXPECT_EQ(frames.submitted, 2);
  EXPECT_EQ(client.frames.size(), 2);
  strand->advance(Milliseconds(10'000.0));
  EXPECT_EQ(frames.submitted, 2);
}

TEST_F(FrameFlowTest, AnAcknowledgementCoversTheFramesBeforeIt) {
  show(1);
  finish();
  show(2);
  finish();
  flow->acknowledge(2);
  show(3);
  finish();
  show(4);
  finish();
  EXPECT_EQ(client.frames.size(), 4);
}

TEST_F(FrameFlowTest, ASecondAcknowledgementOfTheSameFrameIsNoSecondCredit) {
  show(1);
  finish();
  flow->acknowledge(1);
  flow->acknowledge(1);
  for (std::uint32_t revision = 2; revision <= 5; ++revision) {
    show(revision);
    if (!frames.idle()) finish();
  }
  EXPECT_EQ(client.frames.size(), 3);
}

TEST_F(FrameFlowTest, TakesOnlyTheFramesOnTheirWayAndTheLastAcknowledged) {
  for (const std::uint32_t revision : {1U, 2U, 3U}) {
    show(revision);
    finish();
    flow->acknowledge(revision);
  }
  show(4);
  finish();
  show(5);
  finish();
  // Those of long ago, of the future, and where an unsigned difference wraps around.
  for (const std::uint32_t frame : {0U, 2U, 6U, 99'999U, 2'147'483'652U, 2'147'483'700U, ~0U}) {
    EXPECT_THROW(flow->acknowledge(frame), Error) << frame;
  }
  EXPECT_NO_THROW(flow->acknowledge(3));
  EXPECT_NO_THROW(flow->acknowledge(5));
  EXPECT_THROW(flow->acknowledge(4), Error);
}

TEST_F(FrameFlowTest, RefusesTheAcknowledgementOfAFrameNeverSent) {
  EXPECT_THROW(flow->acknowledge(1), Error);
  show(1);
  finish();
  try {
    flow->acknowledge(4);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::out_of_range);
    EXPECT_EQ(error.detail().field, "/frame");
    EXPECT_EQ(error.detail().expected, "1 to 1");
    EXPECT_EQ(error.detail().received, "4");
  }
}

TEST_F(FrameFlowTest, AFrameThatCouldNotBeSentReturnsItsCredit) {
  show(1);
  finish();
  show(2);
  finish();
  show(3);
  EXPECT_EQ(frames.submitted, 2);
  client.frames[0].done(false);
  strand->run();
  EXPECT_EQ(frames.submitted, 3);
}

TEST_F(FrameFlowTest, AReplacedFrameReturnsItsCredit) {
  show(1);
  frames.begin();
  show(2);
  frames.release(kView);
  strand->run();
  show(3);
  EXPECT_EQ(frames.submitted, 3);
}

TEST_F(FrameFlowTest, AFailedFrameReturnsItsCreditAndIsReportedOnce) {
  show(1);
  frames.fail(Error({.code = ErrorCode::render_failed, .message = "no"}));
  strand->run();
  ASSERT_EQ(errors.size(), 1);
  EXPECT_EQ(errors[0].detail().code, ErrorCode::render_failed);
  strand->advance(Milliseconds(5000.0));
  EXPECT_EQ(frames.submitted, 1) << "the same scene is not tried again";
  show(2);
  finish();
  EXPECT_EQ(client.frames.size(), 1);
  show(3);
  finish();
  EXPECT_EQ(client.frames.size(), 2) << "both credits are there";
}

TEST_F(FrameFlowTest, RefinesOnceAfterRestAndThenIsSilent) {
  show(1);
  finish();
  acknowledge_all();
  strand->advance(Milliseconds(199.0));
  EXPECT_EQ(frames.submitted, 1);
  strand->advance(Milliseconds(2.0));
  ASSERT_EQ(frames.submitted, 2);
  const FrameRequest still = finish();
  EXPECT_TRUE(still.quality.still);
  EXPECT_EQ(still.quality.resolution_scale, 1.0);
  EXPECT_EQ(still.quality.supersampling, 2);
  EXPECT_EQ(still.revision, 1);
  EXPECT_TRUE(client.frames.back().header.still_quality);
  acknowledge_all();
  strand->advance(Milliseconds(3'600'000.0));
  EXPECT_EQ(frames.submitted, 2);
  EXPECT_FALSE(strand->has_alarm());
}

TEST_F(FrameFlowTest, AnInputDuringTheStillFrameIsShownNextAndRefinedAgain) {
  show(1);
  finish();
  acknowledge_all();
  strand->advance(Milliseconds(201.0));
  EXPECT_TRUE(frames.begin().quality.still);
  show(2);
  finish();
  const FrameRequest next = finish();
  EXPECT_EQ(next.revision, 2);
  EXPECT_FALSE(next.quality.still);
  acknowledge_all();
  strand->advance(Milliseconds(201.0));
  EXPECT_TRUE(finish().quality.still);
}

TEST_F(FrameFlowTest, AnInputThatComesBeforeTheStillFrameBeginsTakesItsPlace) {
  show(1);
  finish();
  acknowledge_all();
  strand->advance(Milliseconds(201.0));
  EXPECT_EQ(frames.waiting(), 1);
  show(2);
  EXPECT_EQ(frames.submitted, 2);
  const FrameRequest request = finish();
  EXPECT_EQ(request.revision, 2);
  EXPECT_FALSE(request.quality.still);
}

TEST_F(FrameFlowTest, SlowFramesLowerTheResolutionOfTheNextOnes) {
  double scale = 1.0;
  for (std::uint32_t revision = 1; revision <= 12; ++revision) {
    show(revision);
    scale = finish(static_cast<std::uint32_t>(200'000 * scale * scale)).quality.resolution_scale;
    acknowledge_all();
  }
  EXPECT_LT(scale, 0.6);
}

TEST_F(FrameFlowTest, ASlowLinkLowersTheRate) {
  int submitted_before = 0;
  for (std::uint32_t revision = 1; revision <= 60; ++revision) {
    show(revision);
    if (frames.idle()) {
      strand->advance(Milliseconds(20.0));
      continue;
    }
    const std::size_t bytes = revision % 2 == 0 ? 40'000 : 70'000;
    frames.finish(5000, bytes);
    strand->run();
    strand->advance(Milliseconds(static_cast<double>(bytes) * 0.02));  // 400 kbit/s
    acknowledge_all();
    submitted_before = frames.submitted;
  }
  while (!frames.idle()) finish();
  acknowledge_all();
  show(100);
  show(101);
  EXPECT_LE(frames.submitted, submitted_before + 1) << "one may be due, the next waits";
  EXPECT_TRUE(strand->has_alarm());
}

TEST_F(FrameFlowTest, NumbersWrapAroundWithoutLosingCredits) {
  show(0xFFFFFFFF);
  finish();
  acknowledge_all();
  show(0);
  finish();
  EXPECT_EQ(client.frames.back().header.revision, 0);
}

TEST_F(FrameFlowTest, ReleasesItsViewAndHearsNothingMoreOnceGone) {
  show(1);
  frames.begin();
  flow.reset();
  EXPECT_TRUE(frames.released.contains(kView));
  frames.finish();
  strand->run();
  EXPECT_TRUE(client.frames.empty());
}

}  // namespace
}  // namespace cutaway
