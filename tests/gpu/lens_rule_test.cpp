// The cutaway's four cases against a closed form: two concentric spheres and the lens' sphere,
// nothing but quadratics.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

struct Crossing {
  double in_mm;
  double out_mm;
};

std::optional<Crossing> cross_sphere(const ViewRay& ray, glm::dvec3 centre, double radius) {
  const glm::dvec3 from = ray.origin_mm - centre;
  const double b = glm::dot(from, ray.direction);
  const double d = b * b - glm::dot(from, from) + radius * radius;
  if (d <= 0.0) return std::nullopt;
  return Crossing{-b - std::sqrt(d), -b + std::sqrt(d)};
}

/// What a ray meets.
enum class Event { nothing, skin, bone, lens_front, lens_back };

struct Expected {
  Event event = Event::nothing;
  double distance_mm = 0.0;

  int branch() const {
    if (event == Event::nothing) return -1;
    return event == Event::bone || event == Event::lens_front ? kFocus : kContext;
  }
};

bool within(double t, const std::optional<Crossing>& c) {
  return c && t > c->in_mm && t < c->out_mm;
}

/// First relevant event. Material is solid: a lens boundary inside of a branch's material is a cap.
Expected closed_form(const ViewRay& ray, const Lens& lens, const ShellField& shells) {
  const auto skin = cross_sphere(ray, glm::dvec3(0.0), shells.skin_radius_mm);
  const auto bone = cross_sphere(ray, glm::dvec3(0.0), shells.bone_radius_mm);
  const auto hole = lens.mode == LensMode::none ? std::nullopt
                                                : cross_sphere(ray, lens.centre_mm, lens.radius_mm);
  if (!skin) return {};
  if (!within(skin->in_mm, hole)) {
    // The skin is met first, unless the lens holds its front; the lens may also be entered before.
    if (!hole || skin->in_mm < hole->in_mm || skin->in_mm > hole->out_mm)
      return {Event::skin, skin->in_mm};
  }
  if (bone && within(bone->in_mm, hole)) return {Event::bone, bone->in_mm};
  if (within(hole->in_mm, bone)) return {Event::lens_front, hole->in_mm};
  if (within(hole->out_mm, skin)) return {Event::lens_back, hole->out_mm};
  return {};
}

/// How far along its normal the surface of an event may be from the closed form's: h^2/(4r) of
/// trilinear values, twice as much where the ray grazes it, and what refinement and floats leave.
double surface_error_mm(Event event, const ShellField& shells) {
  constexpr double kRestMm = 0.004;
  if (event == Event::skin) return 2.0 / (4.0 * shells.skin_radius_mm) + kRestMm;
  return event == Event::bone ? 2.0 / (4.0 * shells.bone_radius_mm) + kRestMm : kRestMm;
}

double cosine_at(const ViewRay& ray, const Expected& expected, const Lens& lens) {
  const glm::dvec3 point = ray.origin_mm + expected.distance_mm * ray.direction;
  const bool on_shell = expected.event == Event::skin || expected.event == Event::bone;
  const glm::dvec3 normal = glm::normalize(on_shell ? point : point - lens.centre_mm);
  return std::abs(glm::dot(normal, ray.direction));
}

constexpr int kRuleSide = 150;

/// The closed form's picture.
class ExpectedPicture {
 public:
  ExpectedPicture(const Scene& scene, const ShellField& shells) {
    for (int y = 0; y < kRuleSide; ++y) {
      for (int x = 0; x < kRuleSide; ++x) {
        rays_.push_back(ray_through(scene.camera, scene.viewport, {x + 0.5, y + 0.5}));
        events_.push_back(closed_form(rays_.back(), scene.lens, shells));
      }
    }
  }

  const ViewRay& ray(glm::ivec2 at) const { return rays_[number(at)]; }
  const Expected& at(glm::ivec2 at) const { return events_[number(at)]; }

  /// Of the pixel and its eight neighbours, those for which `holds`.
  template <typename Holds>
  int count_around(glm::ivec2 pixel, Holds&& holds) const {
    int count = 0;
    for (int i = 0; i < 9; ++i) {
      const glm::ivec2 neighbour = pixel + glm::ivec2(i % 3 - 1, i / 3 - 1);
      count += holds(at(glm::clamp(neighbour, 0, kRuleSide - 1))) ? 1 : 0;
    }
    return count;
  }

  static std::size_t number(glm::ivec2 at) {
    return static_cast<std::size_t>(at.y) * kRuleSide + at.x;
  }

 private:
  std::vector<ViewRay> rays_;
  std::vector<Expected> events_;
};

class LensPlaces : public testing::TestWithParam<std::tuple<glm::dvec3, double, bool>> {};

TEST_P(LensPlaces, LabelsAndDepthsAreTheClosedForms) {
  const auto [centre, radius, perspective] = GetParam();
  const ShellField shells;
  const auto volume = load(shells_volume(centred_geometry(100), shells));
  const Json document = {
      {"camera",
       {{"projection", perspective ? "perspective" : "orthographic"},
        {"eye_mm", {60, -250, 40}},
        {"target_mm", {0, 0, 0}},
        {"up", {0, 0, 1}},
        {"view_height_mm", 100},
        {"vertical_fov_degrees", 22}}},
      {"context", {{"surface", {{"iso_value", shells.skin_iso_hu}}}}},
      {"focus", {{"surface", {{"iso_value", shells.bone_iso_hu}}}}},
      {"lens", {{"centre_mm", {centre.x, centre.y, centre.z}}, {"radius_mm", radius}}}};
  const Scene scene = scene_for(document, volume, {kRuleSide, kRuleSide});
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const auto context = FramePipeline::read_surface(gpu.view(), kContext);
  const auto focus = FramePipeline::read_surface(gpu.view(), kFocus);
  const ExpectedPicture expected(scene, shells);

  int compared = 0;
  for (int i = 0; i < kRuleSide * kRuleSide; ++i) {
    const glm::ivec2 pixel(i % kRuleSide, i / kRuleSide);
    const Expected& here = expected.at(pixel);
    ASSERT_FALSE(focus[i].w >= 0.0F && context[i].w >= 0.0F);
    const int branch = focus[i].w >= 0.0F ? int{kFocus} : context[i].w >= 0.0F ? int{kContext} : -1;
    // A border may lie a pixel off, and nothing else.
    ASSERT_GT(
        expected.count_around(pixel, [&](const Expected& near) { return near.branch() == branch; }),
        0)
        << pixel.x << "," << pixel.y;
    const int same = expected.count_around(
        pixel, [&](const Expected& near) { return near.event == here.event; });
    if (same < 9 || branch < 0) continue;
    const double depth = branch == kFocus ? focus[i].w : context[i].w;
    const double off_mm = std::abs(depth - here.distance_mm);
    ASSERT_LE(off_mm * cosine_at(expected.ray(pixel), here, scene.lens),
              surface_error_mm(here.event, shells))
        << pixel.x << "," << pixel.y;
    ++compared;
  }
  EXPECT_GT(compared, 3500);
}

INSTANTIATE_TEST_SUITE_P(
    CutawayRule, LensPlaces,
    testing::Combine(testing::Values(glm::dvec3(10, -40, 8), glm::dvec3(0, 0, 0),
                                     glm::dvec3(0, -25, 0), glm::dvec3(20, 30, -10),
                                     glm::dvec3(200, 0, 0)),
                     testing::Values(22.0, 60.0), testing::Bool()));

TEST(CutawayRule, LinesEndWhereTheLensCutsTheFocusOff) {
  // The lens cuts a cap out of a ball; nothing else is there. All of the cap's border is the lens'.
  const auto volume = load(sphere_volume(centred_geometry(96), 40.0));
  const Json flat = {{"name", "tone"}, {"dark", {0.5, 0.5, 0.5}}, {"light", {0.5, 0.5, 0.5}}};
  Json document = {{"camera",
                    {{"projection", "orthographic"},
                     {"eye_mm", {0, -200, 0}},
                     {"target_mm", {0, 0, 0}},
                     {"up", {0, 0, 1}},
                     {"view_height_mm", 60}}},
                   {"context", {{"surface", {{"iso_value", 1000}}}}},
                   {"focus",
                    {{"surface", {{"iso_value", 0}}},
                     {"shading", flat},
                     {"filters", {{{"name", "sobel"}, {"strength", 1}}}}}},
                   {"lens", {{"centre_mm", {0, -40, 0}}, {"radius_mm", 15}}}};
  const auto darkest = [&] {
    const Scene scene = scene_for(document, volume, {120, 120});
    const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
    int least = 255;
    for (int x = 0; x < 60; ++x) {
      const int level = picture.rgb({x, 60}).r;
      if (level != 10) least = std::min(least, level);  // 10: the background
    }
    return least;
  };
  EXPECT_EQ(darkest(), 128);
  document["lens"]["radius_mm"] = 200;  // now the whole ball: its outline is its own
  document["camera"]["view_height_mm"] = 120;
  EXPECT_EQ(darkest(), 0);
}

TEST(CutawayRule, ALensOfNoSizeLeavesTheContextAsItIs) {
  const auto volume = load(shells_volume(centred_geometry(80)));
  Json document = {{"lens", {{"centre_mm", {0, -30, 0}}, {"radius_mm", 0}}}};
  const Scene none = scene_for(document, volume, {100, 80});
  document["lens"] = {{"mode", "none"}, {"centre_mm", {0, -30, 0}}, {"radius_mm", 30}};
  const Scene off = scene_for(document, volume, {100, 80});
  GpuHarness& gpu = GpuHarness::instance();
  EXPECT_EQ(gpu.render(none, volume, settings_for(none)).rgba,
            gpu.render(off, volume, settings_for(off)).rgba);
}

TEST(CutawayRule, ALensAroundTheVolumeShowsTheFocusAlone) {
  const auto volume = load(shells_volume(centred_geometry(80)));
  Json document = {{"lens", {{"centre_mm", {0, 0, 0}}, {"radius_mm", 400}}}};
  const Scene scene = scene_for(document, volume, {100, 80});
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  for (const glm::vec4& context : FramePipeline::read_surface(gpu.view(), kContext))
    EXPECT_LT(context.w, 0.0F);
}

TEST(CutawayRule, OneIsoValueForBothBranchesGivesOneSurface) {
  const auto volume = load(shells_volume(centred_geometry(80)));
  Json document = {{"focus", {{"surface", {{"iso_value", -200}}}}},
                   {"context", {{"surface", {{"iso_value", -200}}}}},
                   {"lens", {{"centre_mm", {0, -40, 0}}, {"radius_mm", 20}, {"cap", "open"}}}};
  const Scene cut = scene_for(document, volume, {100, 80});
  document["lens"] = {{"mode", "none"}};
  const Scene plain = scene_for(document, volume, {100, 80});
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(cut, volume, settings_for(cut));
  const auto focus = FramePipeline::read_surface(gpu.view(), kFocus);
  const auto context = FramePipeline::read_surface(gpu.view(), kContext);
  gpu.render(plain, volume, settings_for(plain));
  const auto whole = FramePipeline::read_surface(gpu.view(), kContext);
  int from_focus = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const float depth = std::max(focus[i].w, context[i].w);
    from_focus += focus[i].w >= 0.0F ? 1 : 0;
    EXPECT_NEAR(std::max(depth, -1.0F), whole[i].w, 0.02F);
  }
  EXPECT_GT(from_focus, 100);
}

}  // namespace
}  // namespace cutaway::test
