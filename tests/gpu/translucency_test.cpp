// Material that lets light through, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr int kTranslucentSide = 60;

/// Orthographic from the front, a millimetre a pixel; no lens: the context alone.
Json front_view(const Json& context_surface) {
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {0, -200, 0}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"view_height_mm", kTranslucentSide}}},
          {"context", {{"surface", context_surface}, {"filters", Json::array()}}},
          {"focus", {{"filters", Json::array()}}},
          {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 10}}}};
}

std::vector<glm::vec4> layers(const Scene& scene, const std::shared_ptr<const LoadedVolume>& volume,
                              double step_voxels, BranchIndex branch = kContext) {
  RenderSettings settings = settings_for(scene);
  settings.step_voxels = step_voxels;
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings);
  return FramePipeline::read_layers(gpu.view(), branch);
}

const glm::vec4& at(const std::vector<glm::vec4>& texels, int x, int y) {
  return texels[static_cast<std::size_t>(y) * kTranslucentSide + x];
}

TEST(Translucency, AHomogeneousBlockTakesWhatItsThicknessSays) {
  const auto volume = load(constant_volume(centred_geometry({41, 11, 41}, {1.0, 0.7, 2.0}), 100.0));
  const double thickness_mm = 10 * 0.7;
  for (const double opacity : {0.02, 0.3, 0.9}) {
    const Scene scene = scene_for(front_view({{"iso_value", 0}, {"opacity", opacity}}), volume,
                                  {kTranslucentSide, kTranslucentSide});
    const double expected = 1.0 - std::pow(1.0 - opacity, thickness_mm);
    // Rays end where nothing more could be seen.
    for (const double step : {0.25, 0.5, 1.0, 2.0})
      EXPECT_NEAR(at(layers(scene, volume, step), 30, 30).a, expected, 0.002) << opacity;
  }
}

TEST(Translucency, ABallTakesWhatEachChordSays) {
  const auto volume = load(sphere_volume(centred_geometry(64), 25.0));
  const double opacity = 0.04;
  const Scene scene = scene_for(front_view({{"iso_value", 0}, {"opacity", opacity}}), volume,
                                {kTranslucentSide, kTranslucentSide});
  for (const double step : {0.5, 1.0}) {
    const auto result = layers(scene, volume, step);
    for (int x = 8; x < 52; x += 4) {
      const double beside_mm = std::hypot(x + 0.5 - 30.0, 0.5);
      const double chord_mm = 2.0 * std::sqrt(std::max(0.0, 25.0 * 25.0 - beside_mm * beside_mm));
      // Ends of the chord are off by h^2/(4r) at most, seen at up to 60 degrees.
      EXPECT_NEAR(at(result, x, 30).a, 1.0 - std::pow(1.0 - opacity, chord_mm), 0.003) << x;
    }
  }
}

TEST(Translucency, AThinShellIsNotTooThinForTheStep) {
  const auto volume = load(sphere_volume(centred_geometry(64), 25.0));
  const Json shell = {{"iso_value", 0.0}, {"upper_value", 0.05}, {"opacity", 0.9}};
  const Scene scene = scene_for(front_view(shell), volume, {kTranslucentSide, kTranslucentSide});
  const double expected = 1.0 - std::pow(0.1, 2 * 0.05);  // through the middle, twice
  for (const double step : {0.25, 0.5, 1.0, 2.0})
    EXPECT_NEAR(at(layers(scene, volume, step), 30, 30).a, expected, 0.01) << step;
}

TEST(Translucency, BranchesShareOneTransmittance) {
  // Skin of 15 mm in front of bone; the lens holds the bone's front.
  const ShellField shells;
  const auto volume = load(shells_volume(centred_geometry(100), shells));
  Json document = front_view({{"iso_value", shells.skin_iso_hu}, {"opacity", 0.05}});
  document["focus"]["surface"] = {{"iso_value", shells.bone_iso_hu}};
  document["lens"] = {{"mode", "cutaway"}, {"centre_mm", {0, -25, 0}}, {"radius_mm", 8}};
  const Scene scene = scene_for(document, volume, {kTranslucentSide, kTranslucentSide});
  const auto context = layers(scene, volume, 0.5);
  const auto focus = layers(scene, volume, 0.5, kFocus);
  const double through_skin = std::pow(0.95, 7.0);  // from 40 to the lens' front at 33
  EXPECT_NEAR(at(context, 30, 30).a, 1.0 - through_skin, 0.005);
  EXPECT_NEAR(at(focus, 30, 30).a, through_skin, 0.005);
  for (std::size_t i = 0; i < context.size(); ++i) {
    EXPECT_LE(context[i].a + focus[i].a, 1.0 + 1e-5);
    // An opaque focus leaves nothing for the background.
    if (focus[i].a > 0.0F) {
      EXPECT_NEAR(context[i].a + focus[i].a, 1.0, 1e-5);
    }
  }
}

TEST(Translucency, AnOpaqueBranchBesideATranslucentOneLooksAsItDoesAlone) {
  const auto volume = load(shells_volume(centred_geometry(80)));
  Json document = front_view(Json::object());
  const Scene opaque = scene_for(document, volume, {kTranslucentSide, kTranslucentSide});
  document["focus"]["surface"] = {{"opacity", 0.5}};  // not shown: there is no lens
  const Scene beside = scene_for(document, volume, {kTranslucentSide, kTranslucentSide});
  GpuHarness& gpu = GpuHarness::instance();
  const auto difference = compare(gpu.render(beside, volume, settings_for(beside)),
                                  gpu.render(opaque, volume, settings_for(opaque)));
  EXPECT_LE(difference.maximum, 1);
}

TEST(Translucency, OpacityZeroIsNotThere) {
  const auto volume = load(shells_volume(centred_geometry(64)));
  Json document = front_view({{"opacity", 0.0}});
  document["background"] = {{"colour", {0.2, 0.4, 0.6}}};
  const Scene scene = scene_for(document, volume, {kTranslucentSide, kTranslucentSide});
  const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
  EXPECT_EQ(picture.rgb({30, 30}), glm::ivec3(51, 102, 153));
}

TEST(Translucency, SkippingEmptySpaceChangesNothing) {
  const auto volume = load(torus_volume(
      centred_geometry({90, 120, 40}, kAnisotropicSpacingMm, oblique_direction()), 25.0, 4.0));
  Json document = front_view({{"iso_value", 0.0}, {"upper_value", 2.0}, {"opacity", 0.2}});
  document["focus"]["surface"] = {{"iso_value", 2.0}, {"opacity", 0.6}};
  document["lens"] = {{"mode", "cutaway"}, {"centre_mm", {25, 0, 0}}, {"radius_mm", 15}};
  const Scene scene = scene_for(document, volume, {kTranslucentSide, kTranslucentSide});
  RenderSettings settings = settings_for(scene);
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture skipping = gpu.render(scene, volume, settings);
  settings.skip_empty_space = false;
  const PictureDifference difference = compare(gpu.render(scene, volume, settings), skipping);
  EXPECT_LE(difference.maximum, 1);  // a skip ends one step's sum early, which rounds elsewhere
}

}  // namespace
}  // namespace cutaway::test
