// What a ray's branches add up to, over every ray of a picture: nothing of it is lost or counted
// twice, wherever it enters and leaves the grid and the lens.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr int kSide = 320;  ///< 102400 rays

glm::ivec2 pixel_of(int ray) { return {ray % kSide, ray / kSide}; }
constexpr double kContextOpacity = 0.006;
constexpr double kFocusOpacity = 0.02;

struct Interval {
  double begin_mm = 0.0;
  double end_mm = 0.0;
  double length_mm() const { return std::max(0.0, end_mm - begin_mm); }
};

Interval overlap(Interval a, Interval b) {
  return {std::max(a.begin_mm, b.begin_mm), std::min(a.end_mm, b.end_mm)};
}

Interval in_box(const ViewRay& ray, const VolumeGeometry& geometry) {
  const glm::dmat4 to_index = patient_to_index(geometry);
  const glm::dvec3 origin(to_index * glm::dvec4(ray.origin_mm, 1.0));
  const glm::dvec3 direction(to_index * glm::dvec4(ray.direction, 0.0));
  const glm::dvec3 at_first = -origin / direction;
  const glm::dvec3 at_last = (glm::dvec3(geometry.size_voxels - 1) - origin) / direction;
  const glm::dvec3 near = glm::min(at_first, at_last);
  const glm::dvec3 far = glm::max(at_first, at_last);
  return {std::max({near.x, near.y, near.z, 0.0}), std::min({far.x, far.y, far.z})};
}

double distance_from_ray_mm(const ViewRay& ray, glm::dvec3 point_mm) {
  return glm::length(glm::cross(point_mm - ray.origin_mm, ray.direction));
}

Interval in_sphere(const ViewRay& ray, glm::dvec3 centre_mm, double radius_mm) {
  const glm::dvec3 to_centre = centre_mm - ray.origin_mm;
  const double middle_mm = glm::dot(to_centre, ray.direction);
  const double square =
      radius_mm * radius_mm - glm::dot(to_centre, to_centre) + middle_mm * middle_mm;
  const double half_mm = std::sqrt(std::max(0.0, square));
  return {middle_mm - half_mm, middle_mm + half_mm};
}

/// One value everywhere, so that what a ray meets is its length alone; seen at a slant.
class Conservation : public testing::Test {
 protected:
  Conservation()
      : volume_(load(constant_volume(
            centred_geometry({60, 90, 40}, kAnisotropicSpacingMm, oblique_direction()), 100.0))) {}

  Scene scene(const char* lens_mode) const {
    return scene_for(
        {{"camera", {{"eye_mm", {90, -200, 70}}, {"target_mm", {2, 1, -3}}, {"up", {0.1, 0, 1}}}},
         {"context", {{"surface", {{"iso_value", 0}, {"opacity", kContextOpacity}}}}},
         {"focus", {{"surface", {{"iso_value", 0}, {"opacity", kFocusOpacity}}}}},
         {"lens", {{"mode", lens_mode}, {"centre_mm", {5, -12, 4}}, {"radius_mm", 22}}}},
        volume_, {kSide, kSide});
  }

  double opacity(const std::vector<glm::vec4>& layers, std::size_t i) const {
    return std::max(layers[i].a, 0.0F);
  }

  std::shared_ptr<const LoadedVolume> volume_;
};

TEST_F(Conservation, EachRayIsAsLongAsItsWayThroughTheGrid) {
  const Scene shown = scene("none");
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(shown, volume_, settings_for(shown));
  const auto layers = FramePipeline::read_layers(gpu.view(), kContext);
  int met = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const ViewRay ray = ray_through(shown.camera, shown.viewport, glm::dvec2(pixel_of(i)) + 0.5);
    const double length_mm = in_box(ray, volume_->volume.geometry).length_mm();
    ASSERT_NEAR(opacity(layers, i), 1.0 - std::pow(1.0 - kContextOpacity, length_mm), 1e-5) << i;
    met += length_mm > 0.0 ? 1 : 0;
  }
  EXPECT_GT(met, 10'000);
}

TEST_F(Conservation, BothBranchesAndTheTransmittanceAddUpToOne) {
  const Scene shown = scene("cutaway");
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(shown, volume_, settings_for(shown));
  const auto context = FramePipeline::read_layers(gpu.view(), kContext);
  const auto focus = FramePipeline::read_layers(gpu.view(), kFocus);
  int both = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const ViewRay ray = ray_through(shown.camera, shown.viewport, glm::dvec2(pixel_of(i)) + 0.5);
    // The chord of a ray that grazes the lens is that of a rounded radius.
    const double beside_mm = distance_from_ray_mm(ray, shown.lens.centre_mm);
    if (std::abs(beside_mm - shown.lens.radius_mm) < 0.5) continue;
    const Interval whole = in_box(ray, volume_->volume.geometry);
    const Interval in_lens =
        overlap(whole, in_sphere(ray, shown.lens.centre_mm, shown.lens.radius_mm));
    const double transmittance =
        std::pow(1.0 - kContextOpacity, whole.length_mm() - in_lens.length_mm()) *
        std::pow(1.0 - kFocusOpacity, in_lens.length_mm());
    ASSERT_NEAR(opacity(context, i) + opacity(focus, i) + transmittance, 1.0, 1e-5) << i;
    both += in_lens.length_mm() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(both, 2'000);
}

/// Two lenses so large that they are the two sides of one plane, y = 0, near the view's axis.
TEST(Exchange, OfTheBranchesAndOfTheLensesSidesIsTheSamePicture) {
  const auto ball = load(sphere_volume(centred_geometry(64), 25.0));
  constexpr double kRadius_mm = 5000.0;
  for (const auto& [front, back] : {std::pair{0.04, 1.0}, {0.03, 0.06}, {0.02, 0.3}}) {
    Scene scene = scene_for({{"camera",
                              {{"projection", "orthographic"},
                               {"eye_mm", {0, -200, 0}},
                               {"target_mm", {0, 0, 0}},
                               {"up", {0, 0, 1}},
                               {"view_height_mm", 60}}},
                             {"context", {{"surface", {{"iso_value", 0}, {"opacity", front}}}}},
                             {"focus", {{"surface", {{"iso_value", 10}, {"opacity", back}}}}},
                             {"lens", {{"mode", "cutaway"}, {"centre_mm", {0, 0, 0}}}}},
                            ball, {60, 60});
    scene.context.filters.clear();
    scene.focus.filters.clear();
    scene.lens.radius_mm = kRadius_mm;
    scene.lens.centre_mm = {0, kRadius_mm, 0};
    GpuHarness& gpu = GpuHarness::instance();
    const BytePicture behind = gpu.render(scene, ball, settings_for(scene));
    std::swap(scene.context, scene.focus);
    scene.lens.centre_mm = {0, -kRadius_mm, 0};
    const BytePicture before = gpu.render(scene, ball, settings_for(scene));
    for (int y = 25; y < 35; ++y) {
      for (int x = 25; x < 35; ++x) {
        const glm::ivec3 apart = glm::abs(behind.rgb({x, y}) - before.rgb({x, y}));
        EXPECT_LE(std::max({apart.r, apart.g, apart.b}), 1) << front << " " << back;
      }
    }
  }
}

/// w + (1 - w) = 1: a Magic Lens between two pictures of one look cannot be seen.
TEST(MagicLens, BetweenTwoBranchesOfOneLookCannotBeSeen) {
  const auto shells = load(shells_volume(centred_geometry(80)));
  for (const double strength : {0.2, 0.5, 0.9}) {
    Json document = {{"context", {{"filters", Json::array()}}},
                     {"lens",
                      {{"mode", "magic"},
                       {"centre_mm", {0, -30, 5}},
                       {"radius_mm", 25},
                       {"strength", strength},
                       {"softness", 0.7}}}};
    Scene scene = scene_for(document, shells, {90, 80});
    scene.focus = scene.context;
    GpuHarness& gpu = GpuHarness::instance();
    const BytePicture under_lens = gpu.render(scene, shells, settings_for(scene));
    scene.lens.mode = LensMode::none;
    EXPECT_LE(compare(under_lens, gpu.render(scene, shells, settings_for(scene))).maximum, 1);
  }
}

}  // namespace
}  // namespace cutaway::test
