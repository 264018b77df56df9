// The Magic Lens: its limits, its footprint, and what it costs.
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr int kMagicSide = 160;
constexpr double kViewHeightMm = 80.0;

const std::shared_ptr<const LoadedVolume>& magic_shells() {
  static const auto volume = load(shells_volume(centred_geometry(100)));
  return volume;
}

Json flat(double level) {
  const Json colour = {level, level, level};
  return {{"name", "tone"}, {"detail", 0}, {"dark", colour}, {"light", colour}};
}

/// White bone over black skin, so that grey is the focus' weight. The lens lies before the patient.
Json weight_scene(double strength, double softness, double radius_mm) {
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {0, -200, 0}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 0, 1}},
            {"view_height_mm", kViewHeightMm}}},
          {"context", {{"shading", flat(0.0)}, {"filters", Json::array()}}},
          {"focus", {{"shading", flat(1.0)}, {"filters", Json::array()}}},
          {"lens",
           {{"mode", "magic"},
            {"centre_mm", {0, -60, 0}},
            {"radius_mm", radius_mm},
            {"strength", strength},
            {"softness", softness}}}};
}

BytePicture render(const Json& document) {
  const Scene scene = scene_for(document, magic_shells(), {kMagicSide, kMagicSide});
  return GpuHarness::instance().render(scene, magic_shells(), settings_for(scene));
}

TEST(MagicLens, OfStrengthZeroIsTheContextExactly) {
  Json document = weight_scene(0.0, 0.35, 15.0);
  document.erase("focus");  // the default look on both branches
  document.erase("context");
  const BytePicture with_lens = render(document);
  document["lens"]["mode"] = "none";
  EXPECT_EQ(with_lens.rgba, render(document).rgba);
}

TEST(MagicLens, OfFullStrengthAndHardEdgeIsTheFocusInsideAndTheContextOutside) {
  Json document = weight_scene(1.0, 0.0, 15.0);
  document["focus"]["shading"] = {{"name", "tone"}};
  document["context"]["shading"] = {{"name", "phong"}};
  const BytePicture picture = render(document);
  document["lens"]["mode"] = "none";
  const BytePicture context = render(document);
  document["context"] = document["focus"];
  document["context"]["surface"] = {{"iso_value", 250}};
  const BytePicture focus = render(document);
  const double radius_px = 15.0 * kMagicSide / kViewHeightMm;
  for (int y = 0; y < kMagicSide; y += 3) {
    for (int x = 0; x < kMagicSide; x += 3) {
      const double beside_px = std::hypot(x + 0.5 - kMagicSide / 2.0, y + 0.5 - kMagicSide / 2.0);
      if (std::abs(beside_px - radius_px) < 1.0) continue;
      const BytePicture& expected = beside_px < radius_px ? focus : context;
      EXPECT_EQ(picture.rgb({x, y}), expected.rgb({x, y})) << x << "," << y;
    }
  }
}

TEST(MagicLens, CoversADiscOfItsRadius) {
  for (const double radius_mm : {8.0, 20.0}) {
    const BytePicture picture = render(weight_scene(1.0, 0.0, radius_mm));
    double covered = 0.0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) covered += picture.rgba[i] > 127;
    // The background is darker than that, and the bone reaches 25 mm.
    const double radius_px = radius_mm * kMagicSide / kViewHeightMm;
    EXPECT_NEAR(covered, M_PI * radius_px * radius_px, 2.0 * M_PI * radius_px);
  }
}

TEST(MagicLens, InPerspectiveCoversTheConeAroundItsSphere) {
  Json document = weight_scene(1.0, 0.0, 12.0);
  document["camera"] = {{"eye_mm", {0, -200, 0}},
                        {"target_mm", {0, 0, 0}},
                        {"up", {0, 0, 1}},
                        {"vertical_fov_degrees", 24}};
  const BytePicture picture = render(document);
  int row = 0;
  for (int x = 0; x < kMagicSide; ++x) row += picture.rgb({x, kMagicSide / 2}).r > 127 ? 1 : 0;
  const double half_angle = std::asin(12.0 / 140.0);
  const double half_px = std::tan(half_angle) / std::tan(glm::radians(12.0)) * kMagicSide / 2.0;
  EXPECT_NEAR(row, 2.0 * half_px, 2.0);
}

TEST(MagicLens, FadesFromItsMiddleToItsRimAsTheSmoothStepSays) {
  const BytePicture picture = render(weight_scene(0.8, 0.5, 20.0));
  const double mm_per_px = kViewHeightMm / kMagicSide;
  int last = 255;
  for (int x = kMagicSide / 2; x < kMagicSide / 2 + 40; ++x) {
    const double offset =
        std::hypot((x + 0.5 - kMagicSide / 2.0) * mm_per_px, 0.5 * mm_per_px) / 20.0;
    const double t = std::clamp((offset - 0.5) / 0.5, 0.0, 1.0);
    const int level = picture.rgb({x, kMagicSide / 2}).r;
    EXPECT_NEAR(level, 255.0 * 0.8 * (1.0 - t * t * (3.0 - 2.0 * t)), 1.5) << x;
    EXPECT_LE(level, last);
    last = level;
  }
}

TEST(MagicLens, LeavesTheContextWholeWhereTheFocusIsEmptyUnlessStrict) {
  Json document = weight_scene(1.0, 0.0, 38.0);  // wider than the bone
  document["context"]["shading"] = flat(0.5);
  document["background"] = {{"colour", {0.0, 0.0, 0.0}}};
  const glm::ivec2 beside_the_bone(kMagicSide / 2 + 60, kMagicSide / 2);  // 30 mm: skin only
  EXPECT_EQ(render(document).rgb(beside_the_bone).r, 128);
  document["lens"]["strict"] = true;
  EXPECT_EQ(render(document).rgb(beside_the_bone).r, 0);
}

TEST(MagicLens, DrawsNoLineAlongItsRim) {
  Json document = weight_scene(1.0, 0.0, 15.0);
  document["focus"]["shading"] = flat(0.5);
  const BytePicture without = render(document);
  document["focus"]["filters"] = {{{"name", "sobel"}, {"strength", 1}}};
  EXPECT_EQ(render(document).rgba, without.rgba);
}

TEST(MagicLens, BehindTheEyeOrOfNoSizeDoesNothing) {
  Json document = weight_scene(1.0, 0.0, 15.0);
  const auto expect_context_alone = [](const BytePicture& picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) ASSERT_LT(picture.rgba[i], 127);
  };
  document["lens"]["centre_mm"] = {0, -300, 0};
  expect_context_alone(render(document));
  document["lens"]["centre_mm"] = {0, -60, 0};
  document["lens"]["radius_mm"] = 0;
  expect_context_alone(render(document));
}

TEST(MagicLens, ItsSlidersCastNoRay) {
  const auto& volume = magic_shells();
  GpuHarness& gpu = GpuHarness::instance();
  GpuVolume gpu_volume(volume, 2048);
  ViewState view;
  const auto draw = [&](const Json& document) {
    const Scene scene = scene_for(document, volume, {kMagicSide, kMagicSide});
    gpu.pipeline().render(view, scene, gpu_volume, settings_for(scene));
    return view.counts();
  };
  const StageCounts first = draw(weight_scene(0.5, 0.5, 15.0));
  StageCounts expected = first;
  ++expected.composite;
  EXPECT_EQ(draw(weight_scene(0.6, 0.2, 15.0)), expected);
}

}  // namespace
}  // namespace cutaway::test
