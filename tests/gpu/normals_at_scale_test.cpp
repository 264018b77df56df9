// Normals under a Gaussian, against what is known of a ball: near the truth without noise, where a
// sparse set of taps would fail, and with noise, where neighbouring voxels do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/normal_taps.h"
#include "render/spline_taps.h"
#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kBallViewport{160, 160};
constexpr double kRadius_mm = 20.3;
constexpr double kContrast = 1000.0;
constexpr double kPointSpread_voxels = 0.7;

/// A ball's edge, blurred by the point spread; noise in shares of the contrast.
std::shared_ptr<const LoadedVolume> ball(double noise, glm::dvec3 spacing_mm = glm::dvec3(1.0)) {
  const glm::ivec3 size = glm::ivec3(glm::ceil(60.0 / spacing_mm));
  std::mt19937 random(7);
  std::normal_distribution<double> deviation(0.0, noise * kContrast);
  const double blur_mm = kPointSpread_voxels * spacing_mm.x;
  return load(sampled_volume(centred_geometry(size, spacing_mm), [&](glm::dvec3 at_mm) {
    const double inside = (kRadius_mm - glm::length(at_mm)) / (blur_mm * std::sqrt(2.0));
    return kContrast * 0.5 * (1.0 + std::erf(inside)) + (noise > 0.0 ? deviation(random) : 0.0);
  }));
}

Scene ball_scene(const std::shared_ptr<const LoadedVolume>& volume, double scale_mm) {
  return scene_for({{"camera",
                     {{"projection", "orthographic"},
                      {"eye_mm", {70, -190, 45}},
                      {"target_mm", {0, 0, 0}},
                      {"up", {0, 0, 1}},
                      {"view_height_mm", 50}}},
                    {"context",
                     {{"surface", {{"iso_value", kContrast / 2.0}}},
                      {"normals", {{"scale_mm", scale_mm}}},
                      {"filters", Json::array()}}},
                    {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
                   volume, kBallViewport);
}

struct Percentiles {
  double median_degrees;
  double most_degrees;  ///< of 95 in a hundred
};

/// Specks of noise in front of the ball and what grazes it are left out.
Percentiles errors(const std::shared_ptr<const LoadedVolume>& volume, double scale_mm) {
  const Scene scene = ball_scene(volume, scale_mm);
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const auto surface = scale_mm > 0.0 ? FramePipeline::read_calmed(gpu.view(), kContext)
                                      : FramePipeline::read_surface(gpu.view(), kContext);
  std::vector<double> degrees;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (surface[i].w < 0.0F) continue;
    const glm::dvec2 pixel(i % kBallViewport.width_px, i / kBallViewport.width_px);
    const ViewRay ray = ray_through(scene.camera, scene.viewport, pixel + 0.5);
    const glm::dvec3 at_mm = ray.origin_mm + double(surface[i].w) * ray.direction;
    if (std::abs(glm::length(at_mm) - kRadius_mm) > 2.0) continue;
    const double cosine = glm::dot(glm::normalize(glm::dvec3(surface[i])), glm::normalize(at_mm));
    degrees.push_back(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
  }
  EXPECT_GT(degrees.size(), 10'000U);
  std::ranges::sort(degrees);
  return {degrees[degrees.size() / 2], degrees[degrees.size() * 95 / 100]};
}

Percentiles told(const char* what, Percentiles found) {
  std::printf("%s: %.2f degrees median, %.2f of 95 in a hundred\n", what, found.median_degrees,
              found.most_degrees);
  return found;
}

TEST(NormalsAtScale, AreNearTheTruthWithoutNoise) {
  const Percentiles calm = told("no noise, 1.5 voxels", errors(ball(0.0), 1.5));
  EXPECT_LE(calm.median_degrees, 1.0);
  EXPECT_LE(calm.most_degrees, 2.5);
}

TEST(NormalsAtScale, CalmNoise) {
  const auto volume = ball(0.15);
  const Percentiles raw = told("noise of 15 %, neighbouring voxels", errors(volume, 0.0));
  const Percentiles calm = told("noise of 15 %, 1.5 voxels", errors(volume, 1.5));
  EXPECT_GT(raw.median_degrees, 6.0);
  EXPECT_LE(calm.median_degrees, 3.0);
  EXPECT_LE(calm.most_degrees, 6.5);
}

TEST(NormalsAtScale, AreNarrowOnTheVolumeItself) {
  const Percentiles calm = told("no noise, 1 voxel", errors(ball(0.0), 1.0));
  EXPECT_LE(calm.median_degrees, 1.0);
  EXPECT_LE(calm.most_degrees, 2.5);
}

TEST(NormalsAtScale, AreWideInSlicesThreeTimesAsThick) {
  const Percentiles calm = told("1 : 1 : 3, 2.5 mm", errors(ball(0.0, {1.0, 1.0, 3.0}), 2.5));
  EXPECT_LE(calm.median_degrees, 1.7);
  EXPECT_LE(calm.most_degrees, 5.0);
}

/// A ball of 3 mm voxels without noise; what is read is how its half-Lambert light, in steps of
/// 1/255, differs from the smooth ball's: 99.8 in a hundred lie within so much of each other.
double rings(const Json& normals) {
  constexpr double kLarge_mm = 100.0;
  const glm::dvec3 spacing_mm(3.0);
  const double blur_mm = kPointSpread_voxels * spacing_mm.x;
  static const auto volume =
      load(sampled_volume(centred_geometry({76, 76, 76}, spacing_mm), [&](glm::dvec3 at_mm) {
        const double inside = (kLarge_mm - glm::length(at_mm)) / (blur_mm * std::sqrt(2.0));
        return kContrast * 0.5 * (1.0 + std::erf(inside));
      }));
  Scene scene =
      scene_for({{"camera",
                  {{"projection", "orthographic"},
                   {"eye_mm", {210, -570, 135}},
                   {"target_mm", {0, 0, 0}},
                   {"up", {0, 0, 1}},
                   {"view_height_mm", 230}}},
                 {"context",
                  {{"surface", {{"iso_value", kContrast / 2.0}}},
                   {"normals", normals},
                   {"filters", Json::array()}}},
                 {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
                volume, kBallViewport);
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const auto surface = normals.empty() ? FramePipeline::read_surface(gpu.view(), kContext)
                                       : FramePipeline::read_calmed(gpu.view(), kContext);
  const glm::dvec3 to_light = light_direction_patient(scene.light, scene.camera);
  std::vector<double> apart;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (surface[i].w < 0.0F) continue;
    const glm::dvec2 pixel(i % kBallViewport.width_px, i / kBallViewport.width_px);
    const ViewRay ray = ray_through(scene.camera, scene.viewport, pixel + 0.5);
    const glm::dvec3 outward = glm::normalize(ray.origin_mm + double(surface[i].w) * ray.direction);
    if (glm::dot(outward, ray.direction) > -0.25) continue;  // grazes
    const glm::dvec3 normal = glm::normalize(glm::dvec3(surface[i]));
    apart.push_back(255.0 * 0.5 * (glm::dot(normal, to_light) - glm::dot(outward, to_light)));
  }
  EXPECT_GT(apart.size(), 10'000U);
  std::ranges::sort(apart);
  return apart[apart.size() * 999 / 1000] - apart[apart.size() / 1000];
}

TEST(NormalsAtScale, CalmTheRingsOfCoarseSlices) {
  const double raw = rings(Json::object());
  const double scaled = rings({{"scale_mm", 4.5}});
  const double automatic = rings({{"scale", "auto"}});
  const double cubic = rings({{"reconstruction", "cubic"}});
  const double cubic_at_scale = rings({{"scale_mm", 4.5}, {"reconstruction", "cubic"}});
  std::printf(
      "rings of 3 mm: %.1f/255 between neighbouring voxels, %.1f at 1.5 voxels, %.1f at auto, %.1f "
      "cubic, %.1f cubic at 1.5 voxels\n",
      raw, scaled, automatic, cubic, cubic_at_scale);
  EXPECT_GT(raw, 15.0);
  EXPECT_LE(scaled, 0.5 * raw);
  EXPECT_LE(automatic, 0.5 * raw);
  EXPECT_LE(cubic, 4.0);
  EXPECT_LE(cubic_at_scale, 0.3 * raw);
}

TEST(SplineTaps, AreAsWideAsTheScaleAsks) {
  const VolumeGeometry geometry = centred_geometry({64, 64, 64}, kAnisotropicSpacingMm);
  const std::vector<glm::ivec3> factors = {{1, 1, 1}, {2, 2, 1}, {4, 4, 2}};
  for (const double scale_mm : {1.5, 2.5, 6.0}) {
    const SplineTaps taps = spline_taps(scale_mm, geometry, factors);
    double weights = 0.0;
    glm::dvec3 mean(0.0);
    glm::dvec3 variance(0.0);
    for (const SplineTap& tap : taps.taps) {
      weights += tap.weight;
      mean += tap.weight * tap.offset_voxels;
      variance += tap.weight * tap.offset_voxels * tap.offset_voxels;
    }
    EXPECT_NEAR(weights, 1.0, 1e-12);
    EXPECT_LT(glm::length(mean), 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      const double factor = factors[taps.level][axis];
      const double own = (factor * factor - 1.0) / 12.0 + factor * factor / 3.0;
      const double wanted = scale_mm / geometry.spacing_mm[axis];
      EXPECT_NEAR(variance[axis] + own, std::max(wanted * wanted, own), 1e-9) << scale_mm << axis;
    }
  }
}

// What rises evenly has one gradient, whatever the Gaussian, the copy and the grid.
TEST(NormalTaps, AreExactForWhatRisesEvenly) {
  const VolumeGeometry geometry =
      centred_geometry({64, 64, 64}, kAnisotropicSpacingMm, oblique_direction());
  const std::vector<glm::ivec3> factors = {{1, 1, 1}, {2, 2, 1}, {4, 4, 2}};
  const glm::dvec3 rise(3.0, -2.0, 5.0);
  for (const double scale_mm : {0.3, 1.0, 2.5, 6.0}) {
    const NormalTaps taps = normal_taps(scale_mm, geometry, factors);
    EXPECT_EQ(taps.pairs.size(), kTapPairs);
    glm::dvec3 gradient(0.0);
    for (const TapPair& pair : taps.pairs) {
      const glm::dvec3 offset_mm =
          geometry.direction_patient * (pair.offset_voxels * geometry.spacing_mm);
      gradient += glm::dot(rise, 2.0 * offset_mm) / 2.0 * pair.gradient;
    }
    EXPECT_LT(glm::distance(gradient, rise), 1e-9) << scale_mm;
  }
}

}  // namespace
}  // namespace cutaway::test
