#include "render/render_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <new>
#include <thread>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class RenderThreads : public testing::Test {
 protected:
  /// How many slabs went to the device.
  int upload(const std::shared_ptr<const LoadedVolume>& volume) {
    int slabs = 0;
    thread_.upload(volume, [&](LoadStage, double) { ++slabs; }, {});
    return slabs;
  }

  static constexpr std::uint64_t kVolumeBytes = std::uint64_t{96} << 20;

  RenderThreads()
      : volume_(load(shells_volume(centred_geometry(64)))),
        // A picture of 64 x 48 takes about a dozen of these steps, one of 1600 x 1200 thousands.
        thread_({}, {.volume_bytes = kVolumeBytes, .step = 6000}) {}

  RenderRequest request(std::uint64_t view, glm::dvec3 background = glm::dvec3(0.0)) {
    const Scene scene =
        scene_for({{"background", {{"colour", {background.r, background.g, background.b}}}}},
                  volume_, {64, 48});
    return {.view = view,
            .volume = volume_,
            .scene = std::make_shared<const Scene>(scene),
            .settings = settings_for(scene)};
  }

  std::future<RenderOutcome> submit(RenderRequest wanted) {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    thread_.submit({std::move(wanted),
                    [promise](RenderOutcome outcome) { promise->set_value(std::move(outcome)); }});
    return promise->get_future();
  }

  /// 64 MiB, which is eight slabs; empty.
  std::shared_ptr<const LoadedVolume> many_slabs() const {
    auto large = std::make_shared<LoadedVolume>(*volume_);
    large->volume.geometry.size_voxels = {256, 256, 512};
    large->volume.voxels = std::vector<std::uint16_t>(std::size_t{256} * 256 * 512);
    return large;
  }

  std::shared_ptr<const LoadedVolume> volume_;
  RenderThread thread_;
};

TEST_F(RenderThreads, NamesItsRenderer) { EXPECT_FALSE(thread_.info().renderer.empty()); }

TEST_F(RenderThreads, EveryJobEndsOnceAndViewsDoNotMix) {
  std::vector<std::future<RenderOutcome>> outcomes;
  for (int round = 0; round < 5; ++round) {
    for (std::uint64_t view = 0; view < 4; ++view) {
      outcomes.push_back(
          submit(request(view, glm::dvec3(static_cast<double>(view) / 4.0, 0.0, 0.0))));
    }
  }
  int drawn = 0;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const RenderOutcome outcome = outcomes[i].get();
    if (std::holds_alternative<RenderReplaced>(outcome)) continue;
    ++drawn;
    const auto& frame = std::get<RenderedFrame>(outcome);
    EXPECT_EQ(frame.picture.plane(0).row(0)[0],
              std::lround(static_cast<double>(i % 4) / 4.0 * 255.0));
  }
  EXPECT_GE(drawn, 4);
}

TEST_F(RenderThreads, AFailedJobLeavesTheOthersAlone) {
  RenderRequest broken = request(1);
  Scene scene = *broken.scene;
  scene.context.shading.parameters.erase("dark");
  broken.scene = std::make_shared<const Scene>(scene);
  EXPECT_TRUE(std::holds_alternative<Error>(submit(broken).get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(2)).get()));
}

TEST_F(RenderThreads, ALargePictureLetsSmallOnesPass) {
  RenderRequest large = request(1);
  large.settings.picture_size_px = {1600, 1200};
  auto drawn_large = submit(large);
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(2)).get()));
  EXPECT_EQ(drawn_large.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(drawn_large.get()));
}

// Else two hundred views that are all being drawn would take the memory of two hundred.
TEST_F(RenderThreads, NoFrameIsBegunWhileThoseBegunTakeUpTheViewsMemory) {
  RenderThread narrow({}, {.view_bytes = 1, .step = 6000});
  RenderRequest large = request(1);
  large.settings.picture_size_px = {400, 300};
  std::vector<std::uint64_t> order;  // on the render thread only
  std::vector<std::future<RenderOutcome>> frames;
  for (RenderRequest wanted : {large, request(2), request(3)}) {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    frames.push_back(promise->get_future());
    const std::uint64_t view = wanted.view;
    narrow.submit({std::move(wanted), [&order, promise, view](RenderOutcome outcome) {
                     order.push_back(view);
                     promise->set_value(std::move(outcome));
                   }});
    if (view == 1) std::this_thread::sleep_for(std::chrono::milliseconds(20));  // it is begun
  }
  for (auto& frame : frames) EXPECT_TRUE(std::holds_alternative<RenderedFrame>(frame.get()));
  EXPECT_EQ(order, (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(RenderThreads, AFrameThatYieldsIsGivenUpForANewerOneOfItsView) {
  RenderRequest still = request(1);
  still.settings.picture_size_px = {1600, 1200};
  still.yields = true;
  auto drawn_still = submit(still);
  // Once this is through, the still has been begun.
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(2)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(drawn_still.get()));
}

/// Its buffers are limited so that a picture of 700 x 500 is drawn in many parts.
class PicturesInParts : public RenderThreads {
 protected:
  static constexpr glm::ivec2 kSize_px{701, 499};

  RenderRequest large(std::uint64_t view, PixelLayout layout) {
    RenderRequest wanted = request(view);
    wanted.settings.picture_size_px = kSize_px;
    wanted.settings.layout = layout;
    return wanted;
  }
  std::future<RenderOutcome> submit_narrow(RenderRequest wanted) {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    narrow_.submit({std::move(wanted),
                    [promise](RenderOutcome outcome) { promise->set_value(std::move(outcome)); }});
    return promise->get_future();
  }

  RenderThread narrow_{{}, {.view_bytes = std::uint64_t{4} << 20, .step = 6000}};
};

TEST_F(PicturesInParts, AreWhatTheyAreAsAWhole) {
  for (const PixelLayout layout : {PixelLayout::yuv420, PixelLayout::yuv444, PixelLayout::rgba}) {
    const RenderOutcome whole = submit(large(1, layout)).get();
    const RenderOutcome in_parts = submit_narrow(large(1, layout)).get();
    ASSERT_TRUE(std::holds_alternative<RenderedFrame>(in_parts));
    const Picture& picture = std::get<RenderedFrame>(in_parts).picture;
    EXPECT_EQ(picture.size_px(), kSize_px);
    EXPECT_EQ(picture.layout(), layout);
    EXPECT_EQ(picture, std::get<RenderedFrame>(whole).picture);
  }
}

TEST_F(PicturesInParts, LetOthersPass) {
  auto drawn = submit_narrow(large(1, PixelLayout::yuv420));
  for (int i = 0; i < 3; ++i)
    EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(2)).get()));
  EXPECT_EQ(drawn.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(drawn.get()));
}

// Tiles were frames of their own once: what renewed the view took the place of one of them.
TEST_F(PicturesInParts, AreNotDisturbedByWhatRenewsTheView) {
  auto drawn = submit_narrow(large(1, PixelLayout::yuv420));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(2)).get()));
  EXPECT_FALSE(narrow_.renew(request(1))) << "what is being drawn does not wait";
  auto waiting = submit_narrow(large(1, PixelLayout::yuv444));
  EXPECT_TRUE(narrow_.renew(request(1)));
  const RenderOutcome first = drawn.get();
  EXPECT_EQ(std::get<RenderedFrame>(first).picture.layout(), PixelLayout::yuv420);
  EXPECT_EQ(std::get<RenderedFrame>(first).picture.size_px(), kSize_px);
  const RenderOutcome second = waiting.get();
  EXPECT_EQ(std::get<RenderedFrame>(second).picture.layout(), PixelLayout::rgba);
  EXPECT_EQ(std::get<RenderedFrame>(second).picture.size_px(), glm::ivec2(64, 48));
}

TEST_F(PicturesInParts, YieldToANewerOneOfTheirView) {
  RenderRequest still = large(1, PixelLayout::yuv444);
  still.yields = true;
  auto drawn = submit_narrow(still);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(2)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(1)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(drawn.get()));
}

TEST_F(PicturesInParts, EndWithTheirViewsRelease) {
  auto drawn = submit_narrow(large(1, PixelLayout::rgba));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(2)).get()));
  narrow_.release(1);
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(drawn.get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit_narrow(request(1)).get()));
}

TEST_F(RenderThreads, AReleasedViewsFrameIsGivenUp) {
  RenderRequest large = request(1);
  large.settings.picture_size_px = {1600, 1200};
  auto drawn = submit(large);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(2)).get()));
  thread_.release(1);
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(drawn.get()));
}

TEST_F(RenderThreads, ForgetsAReleasedViewAndDrawsItAnew) {
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(7)).get()));
  thread_.release(7);
  thread_.release(99);  // never seen
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(7)).get()));
}

// The thread is idle and wakes by the release; it finds the job beside it.
TEST_F(RenderThreads, AReleaseDoesNotEndWhatIsAskedForAfterIt) {
  const RenderRequest wanted = request(7);
  for (int round = 0; round < 30; ++round) {
    ASSERT_TRUE(std::holds_alternative<RenderedFrame>(submit(wanted).get())) << round;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    thread_.release(7);
  }
}

TEST_F(RenderThreads, LetsGoOfAVolumeThatNobodyWants) {
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  const std::weak_ptr<const LoadedVolume> first = volume_;
  volume_ = load(shells_volume(centred_geometry(32)));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  EXPECT_TRUE(first.expired());
}

// Two of the large ones are more than the limit, so that the first has to be put there again.
TEST_F(RenderThreads, KeepsTheVolumesThatWereUsedLastWithinTheLimit) {
  const auto first = many_slabs();
  const auto second = many_slabs();
  EXPECT_GT(upload(first), 1);
  EXPECT_EQ(upload(volume_), 1);
  EXPECT_EQ(upload(first), 0);
  EXPECT_GT(upload(second), 1);  // takes the place of the first and of the small one before it
  EXPECT_EQ(upload(volume_), 1);
  EXPECT_EQ(upload(second), 0);
  EXPECT_GT(upload(first), 1);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
}

TEST_F(RenderThreads, WhatAViewShowsStaysBeforeWhatWasUsedSince) {
  const auto first = many_slabs();
  const auto second = many_slabs();
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  upload(first);
  upload(second);
  EXPECT_EQ(upload(volume_), 0) << "a view rests on it";
  thread_.release(1);
  upload(first);
  upload(second);
  EXPECT_EQ(upload(volume_), 1);
}

TEST_F(RenderThreads, AReceiverThatFailsLeavesTheOthersAlone) {
  thread_.submit({request(1), [](const RenderOutcome&) { throw std::bad_alloc(); }});
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(2)).get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
}

TEST_F(RenderThreads, UploadsWithProgressAndThenDrawsWithoutWaiting) {
  std::vector<double> fractions;
  volume_ = many_slabs();
  thread_.upload(volume_, [&](LoadStage, double fraction) { fractions.push_back(fraction); }, {});
  EXPECT_GT(fractions.size(), 1);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  const std::size_t reports = fractions.size();
  thread_.upload(volume_, [&](LoadStage, double fraction) { fractions.push_back(fraction); }, {});
  EXPECT_EQ(fractions.size(), reports);  // it was there already
}

TEST_F(RenderThreads, FramesOfOthersGoOnDuringAnUpload) {
  const auto large = many_slabs();
  std::vector<std::future<RenderOutcome>> frames;
  std::vector<double> at_frame;  // how far the upload is when a frame is handed over
  double uploaded = 0.0;         // both on the render thread only
  const auto another_frame = [&] {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    frames.push_back(promise->get_future());
    thread_.submit({request(1), [&, promise](RenderOutcome outcome) {
                      at_frame.push_back(uploaded);
                      promise->set_value(std::move(outcome));
                    }});
  };
  thread_.upload(
      large,
      [&](LoadStage, double fraction) {
        if (frames.empty()) another_frame();
        uploaded = fraction;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // a slow device: a turn a slab
      },
      {});
  ASSERT_EQ(frames.size(), 1);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(frames[0].get()));
  EXPECT_LT(at_frame.at(0), 1.0);
}

TEST_F(RenderThreads, AnUploadIsCancelledBetweenTwoSlabs) {
  const auto large = many_slabs();
  std::stop_source stop;
  int slabs = 0;
  EXPECT_THROW(thread_.upload(
                   large,
                   [&](LoadStage, double) {
                     ++slabs;
                     stop.request_stop();
                   },
                   stop.get_token()),
               Cancelled);
  EXPECT_EQ(slabs, 1);
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
}

TEST_F(RenderThreads, RefusesAVolumeWithAnEdgeTooLongAndGoesOn) {
  auto long_one = std::make_shared<LoadedVolume>(*volume_);
  long_one->volume.geometry.size_voxels = {thread_.info().largest_edge_voxels + 1, 4, 4};
  try {
    thread_.upload(long_one, {}, {});
    ADD_FAILURE() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::volume_refused);
    EXPECT_EQ(error.detail().field, "/volume");
  }
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
}

TEST_F(RenderThreads, RefusesAVolumeThatTheDeviceHasNoMemoryForAndGoesOn) {
  auto vast = std::make_shared<LoadedVolume>(*volume_);  // its voxels are never looked at
  vast->volume.geometry.size_voxels = glm::ivec3(thread_.info().largest_edge_voxels);
  try {
    thread_.upload(vast, {}, {});
    ADD_FAILURE() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::too_large);
  }
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
}

}  // namespace
}  // namespace cutaway::test
