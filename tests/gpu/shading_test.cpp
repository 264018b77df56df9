// Shading on an analytic sphere, where every normal is known.
#include <gtest/gtest.h>

#include <set>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "support/reference_shading.h"

namespace cutaway::test {
namespace {

constexpr double kRadiusMm = 40.0;
constexpr Viewport kShadedViewport{200, 200};
constexpr double kShadedHeightMm = 100.0;

const std::shared_ptr<const LoadedVolume>& sphere() {
  static const auto volume = load(sphere_volume(centred_geometry(100), kRadiusMm));
  return volume;
}

/// The whole sphere as context, seen orthographically from the front.
Scene sphere_scene(const Json& shading, glm::dvec3 light_in_camera) {
  return scene_for(
      {{"camera",
        {{"projection", "orthographic"},
         {"eye_mm", {0, -200, 0}},
         {"target_mm", {0, 0, 0}},
         {"up", {0, 0, 1}},
         {"view_height_mm", kShadedHeightMm}}},
       {"context",
        {{"surface", {{"iso_value", 0.0}}}, {"shading", shading}, {"filters", Json::array()}}},
       {"focus", {{"surface", {{"iso_value", 10.0}}}, {"filters", Json::array()}}},
       {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}}},
       {"light",
        {{"frame", "camera"},
         {"direction", {light_in_camera.x, light_in_camera.y, light_in_camera.z}}}},
       {"background", {{"colour", {0, 0, 0}}}}},
      sphere(), kShadedViewport);
}

Json toon() {
  return {{"name", "tone"}, {"detail", 0}, {"dark", {0.2, 0.2, 0.2}}, {"light", {0.8, 0.8, 0.8}}};
}

int count(const BytePicture& picture, int level) {
  int found = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    found += picture.rgba[i] == level ? 1 : 0;
  return found;
}

TEST(ToneShading, DetailZeroHasExactlyTwoColours) {
  const BytePicture picture =
      GpuHarness::instance().render(sphere_scene(toon(), {-0.5, 0.7, 0.5}), sphere(),
                                    settings_for(sphere_scene(toon(), {1, 0, 0})));
  std::set<int> levels;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) levels.insert(picture.rgba[i]);
  EXPECT_EQ(levels, (std::set<int>{0, 51, 204}));  // background, dark, light
}

TEST(ToneShading, ALightAcrossTheViewPutsTheTerminatorThroughTheMiddle) {
  const Scene scene = sphere_scene(toon(), {1, 0, 0});
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
  for (int y = 30; y < 170; y += 10) {
    EXPECT_EQ(picture.rgb({97, y}).r, 51) << y;
    EXPECT_EQ(picture.rgb({102, y}).r, 204) << y;
  }
  EXPECT_NEAR(count(picture, 204), count(picture, 51), 200);  // one column
}

TEST(ToneShading, TheLitShareOfTheDiscFollowsTheLightsAngle) {
  for (const double degrees : {30.0, 60.0, 120.0}) {
    const double angle = glm::radians(degrees);
    const Scene scene = sphere_scene(toon(), {std::sin(angle), 0, std::cos(angle)});
    const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
    const double lit = count(picture, 204);
    EXPECT_NEAR(lit / (lit + count(picture, 51)), (1.0 + std::cos(angle)) / 2.0, 0.01) << degrees;
  }
}

class EveryShading : public testing::TestWithParam<const char*> {};

TEST_P(EveryShading, IsTheReferencesOnTheExactNormal) {
  const Scene scene = sphere_scene(Json::parse(GetParam()), {-0.5, 0.7, 0.5});
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
  const glm::dvec3 light =
      glm::normalize(glm::dvec3(-0.5, -0.5, 0.7));  // patient space: the viewer looks along +y
  const double pixel_mm = kShadedHeightMm / kShadedViewport.height_px;
  for (int y = 25; y < 175; y += 7) {
    for (int x = 25; x < 175; x += 7) {
      const double right = (x + 0.5 - 100) * pixel_mm;
      const double up = (100 - y - 0.5) * pixel_mm;
      const double depth_squared = kRadiusMm * kRadiusMm - right * right - up * up;
      if (depth_squared < 60.0) continue;  // normals turn fast at the rim
      const glm::dvec3 normal = glm::dvec3(right, -std::sqrt(depth_squared), up) / kRadiusMm;
      const glm::dvec3 expected =
          reference::shade(scene.context.shading, normal, light, {0, -1, 0}) * 255.0;
      if (scene.context.shading.parameters.value("detail", 1.0) < 0.5 &&
          std::abs(glm::dot(normal, light)) < 0.02)
        continue;
      // The trilinear field's normals are off by up to 0.03 degrees here; a byte rounds by half.
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(picture.rgb({x, y})[c], expected[c], 1.6) << x << "," << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shading, EveryShading,
    testing::Values(R"({"name": "tone", "detail": 1})",
                    R"({"name": "tone", "detail": 0.4, "terminator": 0.3})",
                    R"({"name": "tone", "detail": 1, "lambert": "clamped"})",
                    R"({"name": "gooch"})",
                    R"({"name": "gooch", "colour": [0.9, 0.3, 0.2], "blue": 0.7, "alpha": 0.5})",
                    R"({"name": "phong"})",
                    R"({"name": "phong", "model": "blinn", "specular": 0.8, "exponent": 10})"));

TEST(GoochShading, WithItsConstantsIsTheToneShaderBetweenItsWarmAndCoolTones) {
  // k_d = 0.6 grey, b = y = 0.4, alpha = 0.2, beta = 0.6
  const Json tone = {
      {"name", "tone"}, {"detail", 1}, {"dark", {0.12, 0.12, 0.52}}, {"light", {0.76, 0.76, 0.36}}};
  const Scene gooch = sphere_scene({{"name", "gooch"}}, {-0.5, 0.7, 0.5});
  const Scene same = sphere_scene(tone, {-0.5, 0.7, 0.5});
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture picture = gpu.render(gooch, sphere(), settings_for(gooch));
  const PictureDifference difference =
      compare(picture, gpu.render(same, sphere(), settings_for(same)));
  // Bit for bit but for 0.2 * 0.6, which in floats is not 0.12: seldom does that turn a byte.
  EXPECT_LE(difference.maximum, 1);
  EXPECT_LE(difference.mean, 1e-4);
}

TEST(GoochShading, IsWarmTowardsTheLightAndCoolAwayFromIt) {
  const Scene scene = sphere_scene({{"name", "gooch"}}, {1, 0, 0});
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
  const glm::ivec3 lit = picture.rgb({176, 100});
  const glm::ivec3 unlit = picture.rgb({24, 100});
  EXPECT_GT(lit.r, lit.b);
  EXPECT_GT(unlit.b, unlit.r);
}

TEST(PhongShading, AHeadlightsLambertTermIsTwoThirdsOfItsPeakOnTheDisc) {
  const Json shading = {
      {"name", "phong"}, {"colour", {1, 1, 1}}, {"ambient", 0}, {"diffuse", 1}, {"specular", 0}};
  const Scene scene = sphere_scene(shading, {0, 0, 1});
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) sum += picture.rgba[i] / 255.0;
  const double radius_px = kRadiusMm * kShadedViewport.height_px / kShadedHeightMm;
  EXPECT_NEAR(sum / (M_PI * radius_px * radius_px), 2.0 / 3.0, 0.005);
}

TEST(PhongShading, BlinnsHighlightIsHalfwayBetweenLightAndViewer) {
  const Json shading = {{"name", "phong"}, {"model", "blinn"}, {"diffuse", 0},
                        {"ambient", 0},    {"specular", 1},    {"exponent", 8}};
  const Scene scene =
      sphere_scene(shading, {1, 0, 1});  // 45 degrees to the right: brightest at 22.5
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings_for(scene));
  double weight = 0.0;
  double sum = 0.0;
  for (int x = 0; x < 200; ++x) {
    const double level = std::pow(picture.rgb({x, 100}).r, 8);
    weight += level;
    sum += level * (x + 0.5);
  }
  const double expected_px = 100.0 + kRadiusMm * std::sin(glm::radians(22.5)) * 2.0;
  EXPECT_NEAR(sum / weight, expected_px, 1.0);
}

}  // namespace
}  // namespace cutaway::test
