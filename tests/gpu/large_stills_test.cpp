// Stills that take much memory: one at a time, by turn of sessions.
#include "services/large_stills.h"

#include <gtest/gtest.h>

#include <future>
#include <mutex>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class LargeStillsTest : public testing::Test {
 protected:
  RenderRequest request(std::uint64_t share, std::uint64_t view) {
    const Scene scene = scene_for(Json::object(), volume_, {900, 700});
    return {.view = view,
            .share = share,
            .volume = volume_,
            .scene = std::make_shared<const Scene>(scene),
            .settings = settings_for(scene),
            .is_followed = false};
  }

  std::future<RenderOutcome> add(std::uint64_t share, std::uint64_t view) {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    auto outcome = promise->get_future();
    stills_.add(request(share, view), [this, promise, view](RenderOutcome result) {
      const std::lock_guard lock(mutex_);
      order_.push_back(view);
      promise->set_value(std::move(result));
    });
    return outcome;
  }

  std::shared_ptr<const LoadedVolume> volume_ = load(shells_volume(centred_geometry(64)));
  // Some parts for each picture, and many steps.
  RenderThread renderer_{{}, {.view_bytes = std::uint64_t{64} << 20, .step = 20000}};
  std::mutex mutex_;
  std::vector<std::uint64_t> order_;
  LargeStills stills_{renderer_};
};

TEST_F(LargeStillsTest, SessionsTakeTurns) {
  std::vector<std::future<RenderOutcome>> outcomes;
  for (const std::uint64_t view : {11, 12, 13}) outcomes.push_back(add(1, view));
  outcomes.push_back(add(2, 21));
  for (auto& outcome : outcomes) {
    const RenderOutcome made = outcome.get();
    ASSERT_TRUE(std::holds_alternative<RenderedFrame>(made));
    EXPECT_EQ(std::get<RenderedFrame>(made).picture.size_px(), glm::ivec2(900, 700));
  }
  EXPECT_EQ(order_, (std::vector<std::uint64_t>{11, 21, 12, 13}));
}

TEST_F(LargeStillsTest, AReleasedOneIsGivenUpAndTheNextIsMade) {
  auto first = add(1, 11);
  auto second = add(1, 12);
  auto third = add(1, 13);
  stills_.release(13);
  stills_.release(11);
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(third.get()));
  EXPECT_TRUE(std::holds_alternative<RenderReplaced>(first.get()));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(second.get()));
}

}  // namespace
}  // namespace cutaway::test
