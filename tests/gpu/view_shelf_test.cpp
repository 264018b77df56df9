// What is kept for views: within its limit, and never what is being drawn.
#include "render/view_shelf.h"

#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class Shelf : public testing::Test {
 protected:
  Shelf()
      : gpu_(GpuHarness::instance()),
        volume_(load(shells_volume(centred_geometry(32)))),
        gpu_volume_(volume_, 2048),
        scene_(scene_for(Json::object(), volume_, {100, 80})) {
    gpu_volume_.upload_rest();
  }

  FramePlan plan(ViewState& view) {
    return gpu_.pipeline().plan(view, scene_, gpu_volume_, settings_for(scene_));
  }

  void draw(ViewShelf& shelf, std::uint64_t view) {
    plan(shelf.pin(view)).finish();
    shelf.keep_within_limit();
    shelf.unpin(view);
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

TEST_F(Shelf, KeepsTheViewsThatWereDrawnLastWithinItsLimit) {
  const std::uint64_t one = bytes_of_one();
  EXPECT_GT(one, 100U * 80U * 32U);  // two surfaces at least
  ViewShelf shelf(3 * one);
  for (std::uint64_t view = 0; view < 10; ++view) {
    draw(shelf, view);
    EXPECT_LE(shelf.used_bytes(), 3 * one);
  }
  const std::uint64_t casts = shelf.pin(9).counts().ray_cast;
  EXPECT_EQ(casts, 1U);
  shelf.unpin(9);
  EXPECT_EQ(shelf.pin(0).counts().ray_cast, 0U);  // drawn anew
}

TEST_F(Shelf, HasRoomWhileWhatIsBeingDrawnTakesLessThanHalf) {
  ViewShelf shelf(4 * bytes_of_one());
  for (std::uint64_t view = 0; view < 3; ++view) {
    EXPECT_TRUE(shelf.has_room());
    plan(shelf.pin(view)).finish();
  }
  EXPECT_FALSE(shelf.has_room());
  shelf.unpin(0);
  EXPECT_TRUE(shelf.has_room());
}

TEST_F(Shelf, TakesNothingAwayThatIsBeingDrawn) {
  ViewShelf shelf(1);
  ViewState& view = shelf.pin(1);
  FramePlan frame = plan(view);
  frame.advance(1000);
  draw(shelf, 2);
  shelf.drop(1);
  frame.finish();
  EXPECT_EQ(view.counts().composite, 1U);
  shelf.unpin(1);
  shelf.keep_within_limit();
  EXPECT_EQ(shelf.used_bytes(), 0U);
}

TEST_F(Shelf, LetsGoOfIdleViews) {
  ViewShelf shelf(std::uint64_t{1} << 40);
  draw(shelf, 1);
  shelf.drop_idle(std::chrono::hours(1));
  EXPECT_GT(shelf.used_bytes(), 0U);
  shelf.drop_idle(std::chrono::seconds(-1));
  EXPECT_EQ(shelf.used_bytes(), 0U);
}

TEST_F(Shelf, AFrameDrawnInStripsBetweenOthersIsTheFrameDrawnAtOnce) {
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

TEST_F(Shelf, APlanThatWasGivenUpLeavesNothingThatPassesForDone) {
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
