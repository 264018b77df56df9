// Where rays meet a surface: against closed forms of a ball, and against the exact cubic in each
// cell of the grid.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/exact_surface.h"
#include "support/gpu_harness.h"
#include "volume/ray_probe.h"

namespace cutaway::test {
namespace {

constexpr double kDepthRadiusMm = 40.0;
constexpr Viewport kDepthViewport{160, 160};

/// What refinement leaves, and floats; a GPU's filter places samples to 1/256 of a voxel.
constexpr double kRestMm = 0.004;

/// The context alone, its surface at value zero.
Scene surface_scene(const std::shared_ptr<const LoadedVolume>& volume, const char* projection) {
  return scene_for({{"camera",
                     {{"projection", projection},
                      {"eye_mm", {70, -200, 45}},
                      {"target_mm", {0, 0, 0}},
                      {"up", {0, 0, 1}},
                      {"vertical_fov_degrees", 26},
                      {"view_height_mm", 100}}},
                    {"context", {{"surface", {{"iso_value", 0}}}}},
                    {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
                   volume, kDepthViewport);
}

std::vector<glm::vec4> surface_of(const Scene& scene,
                                  const std::shared_ptr<const LoadedVolume>& volume,
                                  double step_voxels = 1.0) {
  RenderSettings settings = settings_for(scene);
  settings.step_voxels = step_voxels;
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings);
  return FramePipeline::read_surface(gpu.view(), kContext);
}

/// Calls `look(ray, distance_mm)` for each pixel; distance_mm < 0: nothing was met.
template <typename Look>
void each_pixel(const Scene& scene, const std::vector<glm::vec4>& surface, Look&& look) {
  for (int y = 0; y < kDepthViewport.height_px; ++y) {
    for (int x = 0; x < kDepthViewport.width_px; ++x) {
      const ViewRay ray = ray_through(scene.camera, scene.viewport, {x + 0.5, y + 0.5});
      look(ray, double(surface[static_cast<std::size_t>(y) * kDepthViewport.width_px + x].w));
    }
  }
}

/// How far from the origin the ray passes.
double beside_mm(const ViewRay& ray) {
  return glm::length(glm::cross(ray.origin_mm, ray.direction));
}

/// A ball of 40 mm in a field with a known trilinear error: interpolation along an axis is off by
/// at most h^2/8 of the second derivative.
struct BallField {
  const char* name;
  double (*value)(double radius_mm);
  double error_mm;  ///< of the surface along its normal
};

class BallSurface : public testing::TestWithParam<std::tuple<BallField, const char*>> {};

TEST_P(BallSurface, LiesWhereTheClosedFormSays) {
  const auto& [field, projection] = GetParam();
  const auto volume = load(sampled_volume(
      centred_geometry(96), [&](glm::dvec3 x) { return field.value(glm::length(x)); }));
  const Scene scene = surface_scene(volume, projection);
  int looked_at = 0;
  double worst_mm = 0.0;
  each_pixel(scene, surface_of(scene, volume), [&](const ViewRay& ray, double distance_mm) {
    const double half_chord_mm =
        std::sqrt(std::max(0.0, kDepthRadiusMm * kDepthRadiusMm - beside_mm(ray) * beside_mm(ray)));
    const double cosine = half_chord_mm / kDepthRadiusMm;
    if (cosine < 0.2) return;  // grazing: an error along the normal has no bound along the ray
    const double expected_mm = -glm::dot(ray.origin_mm, ray.direction) - half_chord_mm;
    worst_mm = std::max(worst_mm, std::abs(distance_mm - expected_mm) * cosine);
    ++looked_at;
  });
  EXPECT_LE(worst_mm, field.error_mm + kRestMm);
  EXPECT_GT(looked_at, 9000);
}

INSTANTIATE_TEST_SUITE_P(
    Surface, BallSurface,
    testing::Combine(testing::Values(BallField{"linear",
                                               [](double r) { return kDepthRadiusMm - r; },
                                               1.0 / (4 * 40.0)},
                                     BallField{"quadratic", [](double r) { return 1600.0 - r * r; },
                                               3.0 * 2.0 / 8.0 / 80.0}),
                     testing::Values("orthographic", "perspective")),
    [](const auto& parameter) {
      return std::get<0>(parameter.param).name + std::string("_") + std::get<1>(parameter.param);
    });

/// Nothing but material: rays meet it where they enter its box, whose corners are voxels' middles.
TEST(Surface, OfABlockIsItsBox) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const glm::dmat3& direction : {glm::dmat3(1.0), oblique_direction(), flipped_direction()}) {
    const auto volume = load(
        constant_volume(centred_geometry({60, 70, 30}, kAnisotropicSpacingMm, direction), 100.0));
    for (const char* projection : {"orthographic", "perspective"}) {
      for (const bool along_an_axis : {true, false}) {
        Scene scene = surface_scene(volume, projection);
        const glm::dvec3 askew(unit(random), unit(random), unit(random));
        scene.camera.eye_mm = 150.0 * glm::normalize(along_an_axis ? direction[1] : askew);
        scene.camera.up = direction[2];
        int met = 0;
        each_pixel(scene, surface_of(scene, volume), [&](const ViewRay& ray, double distance_mm) {
          const auto box = intersect_grid(volume->volume.geometry, {ray.origin_mm, ray.direction});
          const double length_mm = box ? box->end_mm - box->begin_mm : 0.0;
          if (box && length_mm < 0.01) return;  // by rounding, an edge may be missed
          ASSERT_EQ(distance_mm >= 0.0, box.has_value());
          if (!box) return;
          ASSERT_NEAR(distance_mm, box->begin_mm, 1e-3);
          ++met;
        });
        EXPECT_GT(met, 3000);
      }
    }
  }
}

class EveryGrid : public testing::TestWithParam<std::tuple<glm::dvec3, glm::dmat3>> {};

TEST_P(EveryGrid, MeetsTheExactCubicOfTheCell) {
  const auto [spacing, direction] = GetParam();
  // Steep at the surface and flat beside it: a straight line between two samples is far off.
  const auto volume = load(sampled_volume(
      centred_geometry(glm::ivec3(96.0 / spacing), spacing, direction), [](glm::dvec3 x) {
        return 1000.0 * std::tanh((kDepthRadiusMm - glm::length(x)) / 1.5) + 400.0;
      }));
  const Scene scene = surface_scene(volume, "perspective");
  int looked_at = 0;
  double worst_mm = 0.0;
  each_pixel(scene, surface_of(scene, volume), [&](const ViewRay& ray, double distance_mm) {
    if (beside_mm(ray) > 0.95 * kDepthRadiusMm)
      return;  // grazing: a chord may be shorter than a step
    const auto expected_mm = reference::first_crossing_mm(volume->volume, ray, 0.0);
    ASSERT_TRUE(expected_mm);
    worst_mm = std::max(worst_mm, std::abs(distance_mm - *expected_mm));
    ++looked_at;
  });
  EXPECT_LE(worst_mm, kRestMm);
  EXPECT_GT(looked_at, 9000);
}

INSTANTIATE_TEST_SUITE_P(Surface, EveryGrid,
                         testing::Combine(testing::Values(glm::dvec3(1.0), kAnisotropicSpacingMm),
                                          testing::Values(glm::dmat3(1.0), oblique_direction())));

TEST(Surface, OfABallIsADiscToThePixelWhateverTheStep) {
  const auto volume = load(sphere_volume(centred_geometry(96), kDepthRadiusMm));
  const Scene scene = surface_scene(volume, "orthographic");
  const double pixel_mm = 100.0 / kDepthViewport.height_px;
  for (const double step_mm : {0.25, 0.5, 1.0, 2.0}) {
    // Trilinear values lie below a field that is concave: the surface is a little within the ball.
    // A ray whose chord is shorter than a step may stay between two samples.
    const double least_mm =
        kDepthRadiusMm - 1.0 / (4 * kDepthRadiusMm) - step_mm * step_mm / (8 * kDepthRadiusMm);
    int covered = 0;
    int undecided = 0;
    each_pixel(scene, surface_of(scene, volume, step_mm),
               [&](const ViewRay& ray, double distance_mm) {
                 covered += distance_mm >= 0.0 ? 1 : 0;
                 if (beside_mm(ray) < least_mm) {
                   EXPECT_GE(distance_mm, 0.0);
                 } else if (beside_mm(ray) > kDepthRadiusMm) {
                   EXPECT_LT(distance_mm, 0.0);
                 } else {
                   ++undecided;
                 }
               });
    EXPECT_LE(undecided, 20) << step_mm;
    const double area_px = M_PI * kDepthRadiusMm * kDepthRadiusMm / (pixel_mm * pixel_mm);
    // Far within a ring of a pixel: the pixels of a disc of 64 miss its area by a few tens.
    EXPECT_NEAR(covered, area_px, 40) << step_mm;
  }
}

}  // namespace
}  // namespace cutaway::test
