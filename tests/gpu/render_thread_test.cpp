#include "render/render_thread.h"

#include <gtest/gtest.h>

#include <future>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class RenderThreads : public testing::Test {
 protected:
  RenderThreads() : volume_(load(shells_volume(centred_geometry(64)))), thread_({}) {}

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
    EXPECT_EQ(frame.pixels.planes.at(0).at(0),
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

TEST_F(RenderThreads, ForgetsAReleasedViewAndDrawsItAnew) {
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(7)).get()));
  thread_.release(7);
  thread_.release(99);  // never seen
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(7)).get()));
}

TEST_F(RenderThreads, LetsGoOfAVolumeThatNobodyWants) {
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  const std::weak_ptr<const LoadedVolume> first = volume_;
  volume_ = load(shells_volume(centred_geometry(32)));
  EXPECT_TRUE(std::holds_alternative<RenderedFrame>(submit(request(1)).get()));
  EXPECT_TRUE(first.expired());
}

}  // namespace
}  // namespace cutaway::test
