// What is kept for views: within its limit, and never what is being drawn.
#include "render/view_cache.h"

#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class ViewCacheTest : public testing::Test {
 protected:
  ViewCacheTest()
      : gpu_(GpuHarness::instance()),
        volume_(load(shells_volume(centred_geometry(32)))),
        gpu_volume_(volume_, 2048),
        scene_(scene_for(Json::object(), volume_, {100, 80})) {
    gpu_volume_.upload_rest();
  }

  FramePlan plan(ViewState& view) {
    return gpu_.pipeline().plan(view, scene_, gpu_volume_, settings_for(scene_));
  }

  void draw(ViewCache& cache, std::uint64_t view) {
    plan(cache.pin(view)).finish();
    cache.keep_within_limit();
    cache.unpin(view);
  }

  std::uint64_t bytes_of_one() {
    ViewState view;
    plan(view).finish();
    return view.bytes();
  }

  GpuHarness& gpu_;
  std::shared_ptr<const LoadedVolume> volume_;
  GpuVolume gpu_volume_;
  Scene scene_;
};

TEST_F(ViewCacheTest, KeepsTheViewsThatWereDrawnLastWithinItsLimit) {
  const std::uint64_t one = bytes_of_one();
  EXPECT_GT(one, 100U * 80U * 32U);  // two surfaces at least
  ViewCache cache(3 * one);
  for (std::uint64_t view = 0; view < 10; ++view) {
    draw(cache, view);
    EXPECT_LE(cache.used_bytes(), 3 * one);
  }
  const std::uint64_t casts = cache.pin(9).counts().ray_cast;
  EXPECT_EQ(casts, 1U);
  cache.unpin(9);
  EXPECT_EQ(cache.pin(0).counts().ray_cast, 0U);  // drawn anew
}

TEST_F(ViewCacheTest, HasRoomWhileWhatIsBeingDrawnTakesLessThanHalf) {
  ViewCache cache(4 * bytes_of_one());
  for (std::uint64_t view = 0; view < 3; ++view) {
    EXPECT_TRUE(cache.has_room());
    plan(cache.pin(view)).finish();
  }
  EXPECT_FALSE(cache.has_room());
  cache.unpin(0);
  EXPECT_TRUE(cache.has_room());
}

TEST_F(ViewCacheTest, TakesNothingAwayThatIsBeingDrawn) {
  ViewCache cache(1);
  ViewState& view = cache.pin(1);
  FramePlan frame = plan(view);
  frame.advance(1000);
  draw(cache, 2);
  cache.drop(1);
  frame.finish();
  EXPECT_EQ(view.counts().composite, 1U);
  cache.unpin(1);
  cache.keep_within_limit();
  EXPECT_EQ(cache.used_bytes(), 0U);
}

TEST_F(ViewCacheTest, LetsGoOfIdleViews) {
  ViewCache cache(std::uint64_t{1} << 40);
  draw(cache, 1);
  cache.drop_idle(std::chrono::hours(1));
  EXPECT_GT(cache.used_bytes(), 0U);
  cache.drop_idle(std::chrono::seconds(-1));
  EXPECT_EQ(cache.used_bytes(), 0U);
}

TEST_F(ViewCacheTest, AFrameDrawnInStripsBetweenOthersIsTheFrameDrawnAtOnce) {
  const BytePicture whole = gpu_.render(scene_, volume_, settings_for(scene_));
  const Scene other = scene_for({{"camera", {{"eye_mm", {200, 0, 30}}}}}, volume_, {50, 40});
  ViewState view;
  ViewState beside;
  FramePlan frame = plan(view);
  int steps = 0;
  while (!frame.is_done()) {
    frame.advance(777);
    gpu_.pipeline().render(beside, other, gpu_volume_, settings_for(other));
    ++steps;
  }
  EXPECT_GT(steps, 50);
  gl::PixelReadback readback;
  FramePipeline::start_readback(view, PixelLayout::rgba, readback);
  EXPECT_EQ(readback.finish().at(0), PixelPlane(whole.size_px, 4, whole.rgba));
}

TEST_F(ViewCacheTest, APlanThatWasGivenUpLeavesNothingThatPassesForDone) {
  const BytePicture whole = gpu_.render(scene_, volume_, settings_for(scene_));
  ViewState view;
  plan(view).advance(2000);
  plan(view).finish();
  gl::PixelReadback readback;
  FramePipeline::start_readback(view, PixelLayout::rgba, readback);
  EXPECT_EQ(readback.finish().at(0), PixelPlane(whole.size_px, 4, whole.rgba));
}

}  // namespace
}  // namespace cutaway::test
