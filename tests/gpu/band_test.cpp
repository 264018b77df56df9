// Bands of values: met from either side, and never too thin for the step.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

/// f = 40 - r: the band (0, upper) is a shell whose outer face is the sphere of 40 mm.
const std::shared_ptr<const LoadedVolume>& ball() {
  static const auto volume = load(sphere_volume(centred_geometry(96), 40.0));
  return volume;
}

Json band_scene(double lower, double upper) {
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {30, -200, 20}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"view_height_mm", 100}}},
          {"context", {{"surface", {{"iso_value", lower}, {"upper_value", upper}}}}},
          {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}};
}

std::vector<glm::vec4> context_surface(const Scene& scene, double step_voxels, bool skip = true) {
  RenderSettings settings = settings_for(scene);
  settings.step_voxels = step_voxels;
  settings.skip_empty_space = skip;
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, ball(), settings);
  return FramePipeline::read_surface(gpu.view(), kContext);
}

auto hits(const std::vector<glm::vec4>& surface) {
  return std::ranges::count_if(surface, [](const glm::vec4& texel) { return texel.w >= 0.0F; });
}

TEST(Band, AHundredthOfAStepIsNeverMissed) {
  const Scene thin = scene_for(band_scene(0.0, 0.01), ball(), {150, 150});
  const Scene whole = scene_for(band_scene(0.0, 1000.0), ball(), {150, 150});
  const auto all = hits(context_surface(whole, 0.25));
  // pi r^2 within a ring of a pixel: a ray that only grazes the ball may stay between two samples.
  EXPECT_NEAR(double(all), 3.14159 * 60.0 * 60.0, 2 * 3.14159 * 60.0);
  for (const double step : {0.25, 0.5, 1.0, 2.0})
    EXPECT_EQ(hits(context_surface(thin, step)), hits(context_surface(whole, step))) << step;
}

TEST(Band, IsMetFromAboveAtItsUpperEnd) {
  Json document = band_scene(10.0, 20.0);
  document["camera"]["projection"] = "perspective";
  document["camera"]["eye_mm"] = {0, 1, 0};
  document["camera"]["target_mm"] = {0, 50, 0};
  const Scene scene = scene_for(document, ball(), {40, 40});
  // The eye is 1 mm beside the ball's centre, where f is above the band: its inner face is at r
  // = 20.
  for (const double step : {0.5, 1.0, 2.0}) {
    const auto surface = context_surface(scene, step);
    EXPECT_NEAR(surface[20 * 40 + 20].w, 19.0, 0.1) << step;
    EXPECT_EQ(hits(surface), 40 * 40) << step;
  }
}

TEST(Band, SkippingEmptySpaceChangesNothing) {
  for (const auto& [lower, upper] : {std::pair{0.0, 0.5}, {10.0, 20.0}, {35.0, 60.0}}) {
    const Scene scene = scene_for(band_scene(lower, upper), ball(), {120, 90});
    for (const double step : {0.5, 1.0})
      EXPECT_EQ(context_surface(scene, step, true), context_surface(scene, step, false)) << lower;
  }
}

}  // namespace
}  // namespace cutaway::test
