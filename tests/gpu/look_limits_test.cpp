// What surfaces' looks make of volumes and views at which there is little to look at: numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kLimitsViewport{64, 48};

/// All that there is, at the widest.
Json everything() {
  const Json branch = {{"shading", {{"name", "tone"}, {"softness", 2}}},
                       {"normals", {{"scale_mm", 20}, {"reconstruction", "cubic"}}},
                       {"occlusion", {{"strength", 1}}},
                       {"shadow", {{"strength", 1}}},
                       {"filters", Json::array()}};
  Json document = {{"context", branch},
                   {"focus", branch},
                   {"lens",
                    {{"opening", "funnel"},
                     {"cap", "section"},
                     {"centre_mm", {0, -20, 0}},
                     {"radius_mm", 20},
                     {"wall", {{"strength", 0.5}, {"deepening", 2}, {"edge_mm", 5}}}}}};
  document["context"]["surface"] = {{"iso_value", -200}};
  document["focus"]["surface"] = {{"iso_value", 250}};
  return document;
}

bool is_finite(const std::vector<glm::vec4>& texels) {
  for (const glm::vec4& texel : texels)
    for (int i = 0; i < 4; ++i)
      if (!std::isfinite(texel[i])) return false;
  return true;
}

/// Draws it with each reconstruction, a wide Gaussian and none.
void expect_numbers(const std::string& name, Json document,
                    const std::shared_ptr<const LoadedVolume>& volume) {
  GpuHarness& gpu = GpuHarness::instance();
  for (const char* reconstruction : {"linear", "cubic"}) {
    for (const double scale_mm : {0.0, 20.0}) {
      for (const char* branch : {"context", "focus"})
        document[branch]["normals"] = {{"reconstruction", reconstruction}, {"scale_mm", scale_mm}};
      const Scene scene = scene_for(document, volume, kLimitsViewport);
      gpu.render(scene, volume, settings_for(scene));
      for (const BranchIndex index : {kContext, kFocus}) {
        EXPECT_TRUE(is_finite(FramePipeline::read_surface(gpu.view(), index))) << name;
        EXPECT_TRUE(is_finite(FramePipeline::read_reach(gpu.view(), index))) << name;
        EXPECT_TRUE(is_finite(FramePipeline::read_shaded(gpu.view(), index))) << name;
        const bool has_calmed = scale_mm > 0.0 || std::string(reconstruction) == "cubic";
        EXPECT_TRUE(!has_calmed || is_finite(FramePipeline::read_calmed(gpu.view(), index)))
            << name;
      }
    }
  }
}

TEST(LookLimits, OfVolumesWithLittleInThem) {
  expect_numbers("a slice", everything(),
                 load(shells_volume(centred_geometry({40, 40, 1}, {2, 2, 5}))));
  expect_numbers("two slices", everything(),
                 load(shells_volume(centred_geometry({40, 40, 2}, {2, 2, 5}))));
  expect_numbers(
      "smaller than the scale", everything(),
      load(shells_volume(centred_geometry(6), {.skin_radius_mm = 2.5, .bone_radius_mm = 1.5})));
  expect_numbers("constant, within", everything(),
                 load(constant_volume(centred_geometry(20), 500.0)));
  expect_numbers("constant, without", everything(),
                 load(constant_volume(centred_geometry(20), -900.0)));
}

TEST(LookLimits, OfAnEyeInTheCavityAndOfLensesOutOfProportion) {
  const auto volume = load(shells_volume(centred_geometry(60)));
  Json in_cavity = everything();
  in_cavity["camera"] = {{"eye_mm", {0, -25, 0}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}};
  expect_numbers("eye in the cavity", in_cavity, volume);
  Json in_middle = in_cavity;
  in_middle["camera"]["eye_mm"] = {0, -20, 0};
  expect_numbers("eye in the lens' middle", in_middle, volume);
  for (const double radius_mm : {0.0, 0.001, 2000.0}) {
    Json document = everything();
    document["lens"]["radius_mm"] = radius_mm;
    expect_numbers("lens of " + std::to_string(radius_mm) + " mm", document, volume);
  }
  Json behind = everything();
  behind["camera"] = {{"eye_mm", {0, 90, 0}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}};
  behind["lens"]["centre_mm"] = {0, 200, 0};
  expect_numbers("a lens behind the eye", behind, volume);
}

}  // namespace
}  // namespace cutaway::test
