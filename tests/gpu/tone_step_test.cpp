// The soft step of the tone shader on an analytic sphere, whose boundary is known at every scale.
// What it is held against is worked out here, with the sphere's own normals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr double kRadiusMm = 56.0;
constexpr int kSide = 128;  ///< of the picture, px; a pixel is a millimetre

const std::shared_ptr<const LoadedVolume>& sphere() {
  static const auto volume = load(sphere_volume(centred_geometry(124), kRadiusMm));
  return volume;
}

Scene sphere_scene(glm::dvec3 light_in_camera, const Json& softness, const Json& more = {}) {
  Json shading = {{"name", "tone"}, {"detail", 0}, {"dark", {0, 0, 0}}, {"light", {1, 1, 1}}};
  shading.update(softness);
  if (!more.is_null()) shading.update(more);
  return scene_for(
      {{"camera",
        {{"projection", "orthographic"},
         {"eye_mm", {0, -200, 0}},
         {"target_mm", {0, 0, 0}},
         {"up", {0, 0, 1}},
         {"view_height_mm", kSide}}},
       {"context",
        {{"surface", {{"iso_value", 0.0}}}, {"shading", shading}, {"filters", Json::array()}}},
       {"focus", {{"surface", {{"iso_value", 10.0}}}, {"filters", Json::array()}}},
       {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}},
       {"light",
        {{"frame", "camera"},
         {"direction", {light_in_camera.x, light_in_camera.y, light_in_camera.z}}}},
       {"background", {{"colour", {0, 0, 0}}}}},
      sphere(), {kSide, kSide});
}

BytePicture draw(const Scene& scene) {
  return GpuHarness::instance().render(scene, sphere(), settings_for(scene));
}

/// Camera axes: right, up, to the viewer. Of the point that is seen there, from the middle, px.
double cosine_at(glm::dvec2 from_middle, glm::dvec3 light) {
  const glm::dvec2 n = from_middle / kRadiusMm;
  return glm::dot(glm::dvec3(n, std::sqrt(std::max(0.0, 1.0 - glm::dot(n, n)))), light);
}

struct Pixel {
  glm::dvec2 from_middle;
  double lit;  ///< share of 16 x 16 rays
  bool is_inside;
};

Pixel pixel_at(int x, int y, glm::dvec3 light, double step = 0.0) {
  Pixel pixel{{x + 0.5 - kSide / 2.0, kSide / 2.0 - y - 0.5}, 0.0, true};
  for (int i = 0; i < 256; ++i) {
    const glm::dvec2 ray = pixel.from_middle + (glm::dvec2(i % 16, i / 16) + 0.5) / 16.0 - 0.5;
    // Where a neighbour is steeper than four, its normal does not count.
    pixel.is_inside = pixel.is_inside && glm::length(ray) < 0.93 * kRadiusMm;
    pixel.lit += cosine_at(ray, light) >= step ? 1.0 / 256.0 : 0.0;
  }
  return pixel;
}

glm::dvec3 light_at(double degrees, double to_viewer) {
  const double angle = glm::radians(degrees);
  return glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), to_viewer));
}

TEST(ToneStep, OfOnePixelIsThatOfManyRaysAtAnyAngle) {
  for (const double degrees : {2.0, 10.0, 22.5, 30.0, 43.0, 60.0, 77.0, 88.0, 120.0, 170.0}) {
    for (const double to_viewer : {0.05, 0.6}) {
      const glm::dvec3 light = light_at(degrees, to_viewer);
      const BytePicture picture = draw(sphere_scene(light, {{"softness", 1}}));
      double squares = 0.0;
      double worst = 0.0;
      int count = 0;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const Pixel pixel = pixel_at(x, y, light);
          if (!pixel.is_inside || pixel.lit == 0.0 || pixel.lit == 1.0) continue;
          const double error = picture.rgb({x, y}).r / 255.0 - pixel.lit;
          squares += error * error;
          worst = std::max(worst, std::abs(error));
          ++count;
        }
      }
      EXPECT_GT(count, 80);
      EXPECT_LE(std::sqrt(squares / count), 0.012) << degrees << " " << to_viewer;
      EXPECT_LE(worst, 0.04) << degrees << " " << to_viewer;
    }
  }
}

TEST(ToneStep, WhateverItsSoftnessTheLitShareStays) {
  for (const double degrees : {60.0, 90.0, 120.0}) {
    const double angle = glm::radians(degrees);
    const glm::dvec3 light(std::sin(angle), 0.0, std::cos(angle));
    for (const double softness : {1.0, 3.0}) {
      const BytePicture picture = draw(sphere_scene(light, {{"softness", softness}}));
      double drawn = 0.0;
      double expected = 0.0;
      int count = 0;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const Pixel pixel = pixel_at(x, y, light);
          if (!pixel.is_inside) continue;
          drawn += picture.rgb({x, y}).r / 255.0;
          expected += pixel.lit;
          ++count;
        }
      }
      EXPECT_NEAR(drawn / count, expected / count, 0.002) << degrees << " " << softness;
    }
  }
}

TEST(ToneStep, IsAsWideAsItsSoftnessSays) {
  const glm::dvec3 light(1.0, 0.0, 0.0);
  for (const double softness : {4.0, 10.0}) {
    const BytePicture picture = draw(sphere_scene(light, {{"softness", softness}}));
    int between = 0;
    for (int x = 0; x < kSide; ++x) {
      const int level = picture.rgb({x, kSide / 2}).r;
      between += level > 0 && level < 255 ? 1 : 0;
    }
    EXPECT_NEAR(between, softness, 1.0);
  }
}

TEST(ToneStep, PerMilleIsOfThePicturesHeight) {
  const glm::dvec3 light(1.0, 0.2, 0.3);
  const double per_mille = 5.0 / kSide * 1000.0;
  EXPECT_EQ(draw(sphere_scene(light, {{"softness_per_mille", per_mille}})).rgba,
            draw(sphere_scene(light, {{"softness", 5}})).rgba);
}

TEST(ToneStep, FollowsAMovedTerminatorAndTheClampedLambertsOwn) {
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.8, 0.3, 0.5));
  const std::pair<Json, double> cases[] = {{{{"terminator", 0.3}}, 0.3},
                                           {{{"lambert", "clamped"}}, 0.5}};
  for (const auto& [more, step] : cases) {
    const BytePicture picture = draw(sphere_scene(light, {{"softness", 1}}, more));
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const Pixel pixel = pixel_at(x, y, light, step);
        if (pixel.is_inside) {
          ASSERT_NEAR(picture.rgb({x, y}).r / 255.0, pixel.lit, 0.06) << more << x << "," << y;
        }
      }
    }
  }
}

TEST(ToneStep, IsHardWhereItIsNotAskedFor) {
  const BytePicture picture = draw(sphere_scene({1.0, 0.2, 0.3}, {{"softness", 0}}));
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    ASSERT_TRUE(picture.rgba[i] == 0 || picture.rgba[i] == 255);
}

/// A narrower one would have stairs again.
TEST(ToneStep, IsAPixelWideInASmallPicture) {
  const Scene scene = sphere_scene({1.0, 0.3, 0.3}, {{"softness", 1}});
  RenderSettings settings = settings_for(scene);
  settings.picture_size_px = {kSide / 2, kSide / 2};
  settings.resolution_scale = 0.5;
  expect_like_reference("tone-step-small", scene, sphere(), settings, tolerance_for(scene));
  const BytePicture picture = GpuHarness::instance().render(scene, sphere(), settings);
  int between = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
    between += picture.rgba[i] > 0 && picture.rgba[i] < 255 ? 1 : 0;
  EXPECT_GT(between, kSide / 4);
}

TEST(ToneStep, OfSeveralRaysAPixelIsTheReferences) {
  const Scene scene = sphere_scene({1.0, 0.3, 0.3}, {{"softness", 2}});
  RenderSettings settings = settings_for(scene);
  settings.supersampling = 2;
  expect_like_reference("tone-step-rays", scene, sphere(), settings, tolerance_for(scene));
}

}  // namespace
}  // namespace cutaway::test
