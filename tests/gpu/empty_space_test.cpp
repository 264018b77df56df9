// Skipping empty space must change nothing but the time.
#include <gtest/gtest.h>

#include <random>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "volume/phantoms.h"

namespace cutaway::test {
namespace {

void expect_same_bytes(const Scene& scene, const std::shared_ptr<const LoadedVolume>& volume,
                       double step_voxels) {
  RenderSettings settings = settings_for(scene);
  settings.step_voxels = step_voxels;
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture skipping = gpu.render(scene, volume, settings);
  const auto surface = FramePipeline::read_surface(gpu.view(), kContext);
  settings.skip_empty_space = false;
  const BytePicture walking = gpu.render(scene, volume, settings);
  EXPECT_EQ(surface, FramePipeline::read_surface(gpu.view(), kContext));
  EXPECT_EQ(skipping.rgba, walking.rgba);
}

TEST(EmptySpace, SkippingLeavesEveryByteAsItIs) {
  const auto volume = load(make_phantom({PhantomKind::head, 96}, {}, {}));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  for (int i = 0; i < 6; ++i) {
    const glm::dvec3 direction =
        glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
    const glm::dvec3 eye = 500.0 * direction;
    const Json document = {
        {"camera",
         {{"eye_mm", {eye.x, eye.y, eye.z}}, {"target_mm", {0, 0, 0}}, {"up", {0.1, 0.2, 1.0}}}},
        {"context", {{"surface", {{"iso_value", -200 + 100 * anywhere(random)}}}}},
        {"focus", {{"surface", {{"iso_value", 250 + 200 * anywhere(random)}}}}}};
    expect_same_bytes(scene_for(document, volume, {128, 96}), volume, i % 2 == 0 ? 1.0 : 0.5);
  }
}

TEST(EmptySpace, SkipsNothingThatAnObliqueAnisotropicGridHolds) {
  const auto volume = load(torus_volume(
      centred_geometry({90, 120, 40}, kAnisotropicSpacingMm, oblique_direction()), 25.0, 4.0));
  const Json document = {{"context", {{"surface", {{"iso_value", 0.0}}}}},
                         {"focus", {{"surface", {{"iso_value", 2.0}}}}},
                         {"lens", {{"centre_mm", {25, 0, 0}}, {"radius_mm", 15}}}};
  expect_same_bytes(scene_for(document, volume, {160, 120}), volume, 1.0);
}

TEST(EmptySpace, SkipsNothingHoweverOneLooks) {
  const auto volume = load(make_phantom({PhantomKind::head, 64}, {}, {}));
  const Json far = {{"eye_mm", {120, -400, 150}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}};
  const Json inside = {{"eye_mm", {10, -20, 15}}, {"target_mm", {0, 60, 0}}, {"up", {0, 0, 1}}};
  Json orthographic = far;
  orthographic.update({{"projection", "orthographic"}, {"view_height_mm", 150}});
  const Json bone = {{"iso_value", 200}, {"upper_value", 900}};
  const Json filtered = Json::array({{{"name", "kuwahara"}, {"radius", 3}}, {{"name", "sobel"}}});
  const std::vector<Json> views = {
      {{"camera", orthographic}},
      {{"camera", inside}},
      {{"camera", far}, {"lens", {{"mode", "magic"}, {"radius_mm", 40}}}},
      {{"camera", far}, {"lens", {{"mode", "none"}}}},
      {{"camera", far}, {"focus", {{"surface", bone}}}, {"context", {{"surface", bone}}}},
      {{"camera", far}, {"focus", {{"filters", filtered}}}, {"context", {{"filters", filtered}}}}};
  for (const Json& view : views) expect_same_bytes(scene_for(view, volume, {101, 67}), volume, 1.0);
}

TEST(EmptySpace, AVolumeWithoutAnySurfaceIsBackground) {
  const auto volume = load(constant_volume(centred_geometry(32), -1000.0));
  const Scene scene = scene_for({{"context", {{"surface", {{"iso_value", -200}}}}},
                                 {"focus", {{"surface", {{"iso_value", 250}}}}},
                                 {"background", {{"colour", {0.2, 0.4, 0.6}}}}},
                                volume, {40, 30});
  const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
  for (int x = 0; x < 40; ++x) EXPECT_EQ(picture.rgb({x, 15}), glm::ivec3(51, 102, 153));
}

}  // namespace
}  // namespace cutaway::test
