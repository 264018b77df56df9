// The funnel's promise: nothing of the context lies between the eye and the focus in the lens,
// whatever the lens, the camera and the funnel.
#include <gtest/gtest.h>

#include <random>

#include "scene/modules.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "support/reference_lens.h"
#include "support/reference_pixels.h"

namespace cutaway::test {
namespace {

constexpr Viewport kFunnelViewport{48, 36};
constexpr double kBone_mm = 25.0;

class Chance {
 public:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  glm::dvec3 direction() {
    return glm::normalize(glm::dvec3(normal_(engine_), normal_(engine_), normal_(engine_)));
  }

 private:
  std::mt19937 engine_{20261130};
  std::normal_distribution<double> normal_;
};

Json to_json(glm::dvec3 v) { return {v.x, v.y, v.z}; }

/// A lens somewhere about the bone, seen from outside of the skin.
Json any_view(const Json& described, Chance& chance) {
  Json shape = {{"name", described.at("name")}};
  for (const Json& parameter : described.at("parameters"))
    shape[parameter.at("name").get<std::string>()] =
        chance.between(parameter.at("minimum"), parameter.at("maximum"));
  const bool is_perspective = chance.between(0.0, 1.0) < 0.5;
  return {{"camera",
           {{"projection", is_perspective ? "perspective" : "orthographic"},
            {"eye_mm", to_json(chance.between(90.0, 300.0) * chance.direction())},
            {"target_mm", to_json(chance.between(0.0, 15.0) * chance.direction())},
            {"up", to_json(chance.direction())},
            {"view_height_mm", 90}}},
          {"context", {{"surface", {{"iso_value", -200}}}, {"filters", Json::array()}}},
          {"focus", {{"surface", {{"iso_value", 250}}}, {"filters", Json::array()}}},
          {"lens",
           {{"opening", "funnel"},
            {"funnel_degrees", chance.between(0.0, 60.0)},
            {"centre_mm", to_json(chance.between(0.0, 30.0) * chance.direction())},
            {"radius_mm", chance.between(8.0, 25.0)},
            {"shape", shape}}}};
}

/// Whether the ray certainly meets the bone within the lens.
bool meets_bone(const ViewRay& ray, const reference::Interval& lens) {
  const double middle_mm = -glm::dot(ray.origin_mm, ray.direction);
  const double nearest_mm = glm::length(ray.origin_mm + middle_mm * ray.direction);
  if (nearest_mm > kBone_mm - 1.5) return false;
  const double half_mm = std::sqrt(kBone_mm * kBone_mm - nearest_mm * nearest_mm);
  return std::max(middle_mm - half_mm, lens.begin_mm) + 1.5 <
         std::min(middle_mm + half_mm, lens.end_mm);
}

struct Seen {
  int focus = 0;   ///< pixels of which the bone in the lens holds
  int hidden = 0;  ///< pixels in which something else does
};

Seen seen(const Json& document, const std::shared_ptr<const LoadedVolume>& volume) {
  const Scene scene = scene_for(document, volume, kFunnelViewport);
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const auto focus = FramePipeline::read_surface(gpu.view(), kFocus);
  const reference::ReferenceLens lens(scene.lens);
  Seen result;
  for (int i = 0; i < kFunnelViewport.width_px * kFunnelViewport.height_px; ++i) {
    const glm::ivec2 at(i % kFunnelViewport.width_px, i / kFunnelViewport.width_px);
    const ViewRay ray =
        reference::ray_of(scene, at, {kFunnelViewport.width_px, kFunnelViewport.height_px});
    const reference::Interval crossed = lens.interval(ray);
    if (crossed.is_empty() || !meets_bone(ray, crossed)) continue;
    ++(focus[i].w >= 0.0F ? result.focus : result.hidden);
  }
  return result;
}

TEST(Funnel, LeavesNothingBeforeTheFocusInAnyLens) {
  const auto volume = load(shells_volume(centred_geometry(100)));
  for (const Json& described : describe_modules().at("lens_shape")) {
    Chance chance;
    Seen opened;
    Seen closed;
    for (int i = 0; i < 24; ++i) {
      Json document = any_view(described, chance);
      const Seen here = seen(document, volume);
      EXPECT_EQ(here.hidden, 0) << document;
      opened.focus += here.focus;
      document["lens"]["opening"] = "closed";
      closed.hidden += seen(document, volume).hidden;
    }
    EXPECT_GT(opened.focus, 1000) << described.at("name");
    EXPECT_GT(closed.hidden, 300) << described.at("name");  // what it is for
  }
}

}  // namespace
}  // namespace cutaway::test
