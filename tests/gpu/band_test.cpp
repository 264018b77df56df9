// Bands of values: met from either side, and never too thin for the step.
#include <gtest/gtest.h>

#include <algorithm>

#include "scene/view_geometry.h"
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

/// How far from the ball's middle each pixel's ray passes, row by row.
std::vector<double> beside_mm(const Scene& scene) {
  std::vector<double> distances;
  for (int y = 0; y < scene.viewport.height_px; ++y) {
    for (int x = 0; x < scene.viewport.width_px; ++x) {
      const ViewRay ray = ray_through(scene.camera, scene.viewport, {x + 0.5, y + 0.5});
      distances.push_back(glm::length(glm::cross(ray.origin_mm, ray.direction)));
    }
  }
  return distances;
}

TEST(Band, AHundredthOfAStepIsNeverMissedWhateverTheStep) {
  const Scene thin = scene_for(band_scene(0.0, 0.01), ball(), {150, 150});
  const Scene whole = scene_for(band_scene(0.0, 1000.0), ball(), {150, 150});
  const std::vector<double> beside = beside_mm(thin);
  for (const double step : {0.25, 0.5, 1.0, 2.0}) {
    const auto surface = context_surface(thin, step);
    EXPECT_EQ(hits(surface), hits(context_surface(whole, step))) << step;
    // A ray that only grazes the ball, whose chord is shorter than a step, may stay between two
    // samples; trilinear values put the surface 0.006 mm within the ball.
    const double least_mm = 40.0 - 0.00625 - step * step / (8.0 * 40.0);
    int wrong = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const bool is_hit = surface[i].w >= 0.0F;
      wrong += (beside[i] < least_mm && !is_hit) || (beside[i] > 40.0 && is_hit) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0) << step;
  }
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
