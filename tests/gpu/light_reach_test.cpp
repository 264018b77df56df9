// Ambient light and shadow against closed forms: in the unit disc onto which the hemisphere is
// projected, what a wall or a cavity leaves open is a segment or a circle.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kReachViewport{120, 120};
constexpr double kSolid = 1000.0;
constexpr double kPointSpread_mm = 0.7;

/// The edge of a body of which `depth_mm` is positive inside.
std::shared_ptr<const LoadedVolume> body(const std::function<double(glm::dvec3)>& depth_mm) {
  return load(sampled_volume(centred_geometry(96), [&](glm::dvec3 at_mm) {
    return kSolid * 0.5 * (1.0 + std::erf(depth_mm(at_mm) / (kPointSpread_mm * std::sqrt(2.0))));
  }));
}

Json from_above(const Json& context, const Json& lens) {
  Json whole = {{"surface", {{"iso_value", kSolid / 2.0}}},
                {"occlusion", {{"strength", 1}, {"range_mm", 16}}},
                {"filters", Json::array()}};
  whole.merge_patch(context);
  return {{"camera",
           {{"projection", "orthographic"},
            {"eye_mm", {0, 0, 400}},
            {"target_mm", {0, 0, 0}},
            {"up", {0, 1, 0}},
            {"view_height_mm", 60}}},
          {"light", {{"frame", "patient"}, {"direction", {0, 0, 1}}}},
          {"context", whole},
          {"focus", {{"surface", {{"iso_value", 1e6}}}}},
          {"lens", lens}};
}

const Json kNoLens = {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}};

class Reach {
 public:
  Reach(const Json& document, const std::shared_ptr<const LoadedVolume>& volume)
      : scene_(scene_for(document, volume, kReachViewport)) {
    GpuHarness& gpu = GpuHarness::instance();
    RenderSettings settings = settings_for(scene_);
    settings.light = {.directions = 64, .samples = 64, .shadow_rays = 16, .shadow_samples = 64};
    gpu.render(scene_, volume, settings);
    values_ = FramePipeline::read_reach(gpu.view(), kContext);
  }

  /// Mean over the pixels around a place on the plane across the view, patient space. What a pixel
  /// holds is the mean of the 4 x 4 whose second in each row and column it is, so that its middle
  /// lies at its lower right corner.
  glm::dvec2 at(double x_mm, double y_mm) const {
    const auto middle = project_px(scene_.camera, scene_.viewport, {x_mm, y_mm, 0.0}).value();
    glm::dvec2 sum(0.0);
    for (int i = 0; i < 9; ++i) {
      const glm::ivec2 pixel =
          glm::ivec2(glm::round(middle)) - 1 + glm::ivec2(i % 3 - 1, i / 3 - 1);
      sum += glm::dvec2(values_.at(std::size_t(pixel.y) * kReachViewport.width_px + pixel.x));
    }
    return sum / 9.0;
  }

 private:
  Scene scene_;
  std::vector<glm::vec4> values_;
};

/// What a wall at `distance` leaves of the ambient light within `range`.
double beside_wall(double distance, double range) {
  const double a = std::min(distance / range, 1.0);
  return 1.0 - (std::acos(a) - a * std::sqrt(1.0 - a * a)) / std::numbers::pi;
}

TEST(LightReach, APlaneHasAllOfIt) {
  const Reach reach(from_above({{"shadow", {{"strength", 1}}}}, kNoLens),
                    body([](glm::dvec3 at) { return -at.z; }));
  EXPECT_GE(reach.at(0, 0).x, 0.99);
  EXPECT_GE(reach.at(0, 0).y, 0.99);
}

TEST(LightReach, FallsTowardsAWallByTheClosedForm) {
  const Reach reach(from_above(Json::object(), kNoLens),
                    body([](glm::dvec3 at) { return std::max(-at.z, -20.0 - at.x); }));
  for (const double distance : {3.0, 6.0, 10.0, 14.0}) {
    const double found = reach.at(-20.0 + distance, 0.0).x;
    std::printf("%.0f mm from a wall: %.3f, by the closed form %.3f\n", distance, found,
                beside_wall(distance, 16.0));
    EXPECT_NEAR(found, beside_wall(distance, 16.0), 0.02) << distance;
  }
}

// A box cut out of what is solid has a face's normal right into its edges.
TEST(LightReach, OfAConcaveEdgeIsTheClosedFormsWithTheFacesNormal) {
  const Json lens = {{"mode", "cutaway"},
                     {"shape", {{"name", "box"}, {"width", 1}, {"height", 1}, {"depth", 1}}},
                     {"centre_mm", {0, 0, 15}},
                     {"radius_mm", 25}};
  const auto volume = body([](glm::dvec3 at) { return 30.0 - at.z; });
  Json document = from_above(Json::object(), lens);
  document["camera"].merge_patch(
      {{"eye_mm", {-22, 0, 400}}, {"target_mm", {-22, 0, 0}}, {"view_height_mm", 12}});
  const Reach edge(document, volume);
  for (const double distance : {0.7, 1.5, 3.0}) {
    const double found = edge.at(-25.0 + distance, 0.0).x;
    std::printf("%.1f mm from an edge: %.3f, by the closed form %.3f\n", distance, found,
                beside_wall(distance, 16.0));
    EXPECT_NEAR(found, beside_wall(distance, 16.0), 0.03) << distance;
  }
  EXPECT_GE(Reach(from_above(Json::object(), lens), volume).at(0.0, 0.0).x, 0.99);
}

// The same at every point of the wall: half of what the opening's angle leaves.
TEST(LightReach, OfACavityIsEverywhereTheOpeningsShare) {
  constexpr double kRadius = 20.0;
  for (const double opening_degrees : {60.0, 90.0, 120.0}) {
    const double under_skin = kRadius * std::cos(glm::radians(opening_degrees));
    const Reach reach(
        from_above(
            {{"occlusion", {{"range_mm", 3.0 * kRadius}}}},
            {{"mode", "cutaway"}, {"centre_mm", {0, 0, -under_skin}}, {"radius_mm", kRadius}}),
        body([](glm::dvec3 at) { return -at.z; }));
    const double expected = 0.5 * (1.0 - std::cos(glm::radians(opening_degrees)));
    for (const double aside : {0.0, 8.0, 14.0}) {
      const double found = reach.at(aside, 0.0).x;
      std::printf("opening of %.0f degrees, %.0f mm aside: %.3f, by the closed form %.3f\n",
                  opening_degrees, aside, found, expected);
      EXPECT_NEAR(found, expected, 0.035) << opening_degrees << " " << aside;
    }
  }
}

TEST(LightReach, AShadowLiesBehindWhatStandsInTheLight) {
  Json document = from_above({{"shadow", {{"strength", 1}, {"softness_degrees", 5}}}}, kNoLens);
  document["light"]["direction"] = {-1, 0, 1};
  const Reach reach(document, body([](glm::dvec3 at) {
                      const double ball = 6.0 - glm::length(at - glm::dvec3(-15.0, 0.0, 15.0));
                      return std::max(-at.z, ball);
                    }));
  EXPECT_LE(reach.at(0.0, 0.0).y, 0.05);  // the ball's middle throws it here
  EXPECT_GE(reach.at(0.0, 20.0).y, 0.95);
  EXPECT_GE(reach.at(20.0, 0.0).y, 0.95);
}

/// Mean difference from many rays that are spread evenly, in steps of 1/255, over what is met.
double from_many_rays(const Scene& scene, const std::shared_ptr<const LoadedVolume>& volume,
                      const LightQuality& quality) {
  GpuHarness& gpu = GpuHarness::instance();
  RenderSettings settings = settings_for(scene);
  settings.light = quality;
  gpu.render(scene, volume, settings);
  const auto found = FramePipeline::read_reach(gpu.view(), kContext);
  static const auto expected = [&] {
    const auto cast =
        reference::render(scene, volume->volume, reference_settings(*volume, settings));
    return std::pair(
        reference::light_reach(
            scene, volume->volume, reference::ReferenceCopy(volume->volume), cast.rays,
            reference::BranchName::context, 1,
            {.directions = 1024, .samples = 64, .shadow_rays = 0, .has_pattern = false}),
        cast.rays);
  }();
  double sum = 0.0;
  int met = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!expected.second.pixels[i].context.is_met) continue;
    sum += 255.0 * std::abs(found[i].x - expected.first.pixels[i].x);
    ++met;
  }
  EXPECT_GT(met, 500);
  return sum / met;
}

TEST(LightReach, OfFewRaysIsNearThatOfManyThatAreSpreadEvenly) {
  const auto volume = body(
      [](glm::dvec3 at) { return std::max(12.0 - glm::length(at - glm::dvec3(0, 0, 8)), -at.z); });
  Json document = from_above(Json::object(), kNoLens);
  document["camera"]["eye_mm"] = {150, 100, 300};
  const Scene scene = scene_for(document, volume, {64, 48});
  const double at_rest = from_many_rays(scene, volume, {16, 16, 0, 0});
  const double at_its_best = from_many_rays(scene, volume, {64, 32, 0, 0});
  std::printf("from 1024 rays: %.2f/255 with 16 x 16, %.2f/255 with 64 x 32\n", at_rest,
              at_its_best);
  EXPECT_LE(at_rest, 3.0);
  EXPECT_LE(at_its_best, 2.0);
}

// What nobody asks for leaves no trace: the picture is the same byte for byte.
TEST(LightReach, OfNoStrengthIsNotLookedFor) {
  const auto volume = body([](glm::dvec3 at) { return std::max(-at.z, -20.0 - at.x); });
  const auto picture = [&](const Json& context) {
    const Scene scene = scene_for(from_above(context, kNoLens), volume, kReachViewport);
    return GpuHarness::instance().render(scene, volume, settings_for(scene)).rgba;
  };
  const auto without = picture({{"occlusion", nullptr}});
  EXPECT_EQ(picture({{"occlusion", {{"strength", 0}}}, {"shadow", {{"strength", 0}}}}), without);
  EXPECT_NE(picture(Json::object()), without);
}

}  // namespace
}  // namespace cutaway::test
