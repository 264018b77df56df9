// What a change of the scene costs: stages run only when what they read has changed.
#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

class Stages : public testing::Test {
 protected:
  Stages() : volume_(load(shells_volume(centred_geometry(64)))), gpu_volume_(volume_, 2048) {
    GpuHarness::instance();
    gpu_volume_.upload_rest();
    document_ = {
        {"camera", {{"eye_mm", {0, -250, 30}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}}},
        {"lens", {{"centre_mm", {0, -40, 0}}, {"radius_mm", 20}}}};
    render();
  }

  void render() {
    const Scene scene = scene_for(document_, volume_, {80, 60});
    GpuHarness::instance().pipeline().render(view_, scene, gpu_volume_, settings_for(scene));
  }

  /// What one more render adds to the counts.
  StageCounts cost_of_render() {
    const StageCounts before = view_.counts();
    render();
    const StageCounts after = view_.counts();
    return {.ray_cast = after.ray_cast - before.ray_cast,
            .shade = {after.shade[0] - before.shade[0], after.shade[1] - before.shade[1]},
            .filters = {after.filters[0] - before.filters[0], after.filters[1] - before.filters[1]},
            .composite = after.composite - before.composite};
  }

  std::shared_ptr<const LoadedVolume> volume_;
  GpuVolume gpu_volume_;
  ViewState view_;
  Json document_;
};

TEST_F(Stages, AnUnchangedSceneCostsNothing) { EXPECT_EQ(cost_of_render(), StageCounts{}); }

TEST_F(Stages, AToneSliderNeverCastsARayAndLeavesTheOtherBranchAlone) {
  document_["focus"]["shading"] = {{"name", "tone"}, {"detail", 0.3}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.shade = {0, 1}, .filters = {0, 1}, .composite = 1}));
}

TEST_F(Stages, AFilterParameterRunsThatFilterAndTheComposite) {
  document_["context"]["filters"] = {{{"name", "kuwahara"}, {"radius", 3}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1}));
}

TEST_F(Stages, AFilterBehindAnUnchangedOneRunsAlone) {
  document_["context"]["filters"] = {{{"name", "kuwahara"}, {"radius", 2}},
                                     {{"name", "sobel"}, {"strength", 0.5}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1}));
  document_["context"]["filters"][1]["strength"] = 0.6;
  EXPECT_EQ(cost_of_render(), (StageCounts{.filters = {1, 0}, .composite = 1}));
  document_["context"]["filters"].erase(1);
  EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1}));
}

TEST_F(Stages, TheBackgroundIsTheCompositesOwn) {
  document_["background"] = {{"colour", {0.5, 0.5, 0.5}}};
  EXPECT_EQ(cost_of_render(), (StageCounts{.composite = 1}));
}

TEST_F(Stages, AMovedLensOrCameraCastsRays) {
  document_["lens"]["centre_mm"] = {5, -40, 0};
  EXPECT_EQ(cost_of_render().ray_cast, 1U);
  document_["camera"]["eye_mm"] = {20, -250, 30};
  EXPECT_EQ(cost_of_render().ray_cast, 1U);
}

TEST_F(Stages, EachSampleBelongsToOneBranchOrTheBackground) {
  const auto context = FramePipeline::read_surface(view_, kContext);
  const auto focus = FramePipeline::read_surface(view_, kFocus);
  int held[3] = {0, 0, 0};
  for (std::size_t i = 0; i < context.size(); ++i) {
    const int holders = (context[i].w >= 0.0F ? 1 : 0) + (focus[i].w >= 0.0F ? 1 : 0);
    ASSERT_LE(holders, 1);
    ++held[holders == 0 ? 2 : focus[i].w >= 0.0F ? 1 : 0];
  }
  for (const int pixels : held) EXPECT_GT(pixels, 50);
}

}  // namespace
}  // namespace cutaway::test
