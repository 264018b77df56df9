// Two branches on one ray: their shares add up, they are exchangeable, and the lens' rule is that
// of the nearer of two pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"
#include "support/reference_shading.h"

namespace cutaway::test {
namespace {

constexpr Viewport kViewport{120, 100};

const ShellField kShells;

const std::shared_ptr<const LoadedVolume>& shells() {
  static const auto volume = load(shells_volume(centred_geometry(96), kShells));
  return volume;
}

/// Skin as context and bone as focus, each of an opacity a millimetre, without filters. No value
/// is beyond the bone's iso-value and 1000 HU, so the skin's band is all that is not bone.
Json shells_scene(double context_opacity, double focus_opacity) {
  const auto flat = [](double r, double g, double b) {
    return Json{{"name", "tone"}, {"dark", {0.2 * r, 0.2 * g, 0.2 * b}}, {"light", {r, g, b}}};
  };
  return {
      {"camera",
       {{"projection", "perspective"},
        {"eye_mm", {60, -250, 40}},
        {"target_mm", {0, 0, 0}},
        {"up", {0, 0, 1}},
        {"vertical_fov_degrees", 22}}},
      {"context",
       {{"surface",
         {{"iso_value", kShells.skin_iso_hu}, {"upper_value", 0.0}, {"opacity", context_opacity}}},
        {"shading", flat(0.9, 0.7, 0.3)},
        {"filters", Json::array()}}},
      {"focus",
       {{"surface", {{"iso_value", kShells.bone_iso_hu}, {"opacity", focus_opacity}}},
        {"shading", flat(0.3, 0.6, 0.9)},
        {"filters", Json::array()}}},
      {"background", {{"colour", {0.1, 0.2, 0.3}}}},
      {"lens", {{"centre_mm", {10, -30, 8}}, {"radius_mm", 24}}}};
}

struct Rendered {
  BytePicture picture;
  std::array<std::vector<glm::vec4>, kBranches> surfaces;
  std::array<std::vector<glm::vec4>, kBranches> layers;  ///< where a branch is translucent
};

Rendered render(const Scene& scene, double step_voxels = 1.0) {
  RenderSettings settings = settings_for(scene);
  settings.step_voxels = step_voxels;
  GpuHarness& gpu = GpuHarness::instance();
  Rendered rendered{gpu.render(scene, shells(), settings), {}, {}};
  const bool is_translucent =
      scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0;
  for (const BranchIndex branch : {kContext, kFocus}) {
    rendered.surfaces[branch] = FramePipeline::read_surface(gpu.view(), branch);
    if (is_translucent) rendered.layers[branch] = FramePipeline::read_layers(gpu.view(), branch);
  }
  return rendered;
}

Scene resolved(const Json& document) { return scene_for(document, shells(), kViewport); }

/// One accumulator over all that a ray meets, by the closed form of the field and in steps far
/// smaller than a voxel.
struct Accumulated {
  glm::dvec3 colour{0.0};  ///< premultiplied, both branches together
  double transmittance = 1.0;
};

Accumulated one_accumulator(const Scene& scene, const ViewRay& ray) {
  constexpr double kStepMm = 0.02;
  const glm::dvec3 to_light = light_direction_patient(scene.light, scene.camera);
  Accumulated sum;
  for (double t = 190.0; t < 340.0; t += kStepMm) {
    const glm::dvec3 x = ray.origin_mm + t * ray.direction;
    const bool is_in_lens = glm::distance(x, scene.lens.centre_mm) < scene.lens.radius_mm;
    const Branch& branch = is_in_lens ? scene.focus : scene.context;
    if (!branch.surface.band.contains(kShells.value(x))) continue;
    const double opacity = 1.0 - std::pow(1.0 - branch.surface.opacity, kStepMm);
    const glm::dvec3 out = glm::normalize(x);
    const glm::dvec3 normal = glm::dot(out, ray.direction) > 0.0 ? -out : out;
    sum.colour += sum.transmittance * opacity *
                  reference::shade(branch.shading, normal, to_light, -ray.direction);
    sum.transmittance *= 1.0 - opacity;
  }
  return sum;
}

class TranslucentBranches : public testing::TestWithParam<std::pair<double, double>> {
 protected:
  TranslucentBranches()
      : scene_(resolved(shells_scene(GetParam().first, GetParam().second))),
        rendered_(render(scene_, 0.25)) {}

  /// Calls `look(pixel, number of the pixel, accumulated)` for pixels all over the picture.
  template <typename Look>
  void each_pixel(Look&& look) const {
    for (int y = 4; y < kViewport.height_px; y += 7) {
      for (int x = 4; x < kViewport.width_px; x += 7) {
        const ViewRay ray = ray_through(scene_.camera, scene_.viewport, {x + 0.5, y + 0.5});
        look(glm::ivec2(x, y), static_cast<std::size_t>(y) * kViewport.width_px + x,
             one_accumulator(scene_, ray));
      }
    }
  }

  Scene scene_;
  Rendered rendered_;
};

TEST_P(TranslucentBranches, HaveOpacitiesThatAddUpToOneWithTheTransmittance) {
  int both = 0;
  each_pixel([&](glm::ivec2, std::size_t i, const Accumulated& sum) {
    // Where no ray was cast, there is a negative number.
    const double context = std::max(rendered_.layers[kContext][i].a, 0.0F);
    const double focus = std::max(rendered_.layers[kFocus][i].a, 0.0F);
    // Ends of the material are off by h^2/(4r), at a slant, and by the closed form's own steps.
    EXPECT_NEAR(context + focus + sum.transmittance, 1.0, 0.006) << i;
    both += context > 0.01 && focus > 0.01 ? 1 : 0;
  });
  EXPECT_GT(both, 10);
}

TEST_P(TranslucentBranches, WithoutFiltersAreOneAccumulator) {
  each_pixel([&](glm::ivec2 pixel, std::size_t i, const Accumulated& sum) {
    const glm::dvec3 expected = sum.colour + sum.transmittance * scene_.background.colour;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(rendered_.picture.rgb(pixel)[c], 255.0 * expected[c], 1.6) << i;
  });
}

INSTANTIATE_TEST_SUITE_P(Branches, TranslucentBranches,
                         testing::Values(std::pair{0.02, 0.03}, std::pair{0.05, 0.01},
                                         std::pair{0.01, 0.2}));

TEST(Branches, ExchangedUnderALensThatHoldsAllAreTheSamePicture) {
  for (const auto& [context, focus] : {std::pair{1.0, 1.0}, {0.04, 1.0}, {0.04, 0.02}}) {
    Json document = shells_scene(context, focus);
    document["context"]["filters"] = {{{"name", "kuwahara"}}, {{"name", "sobel"}}};
    Scene scene = resolved(document);
    scene.lens.mode = LensMode::none;
    const Rendered as_context = render(scene);
    std::swap(scene.context, scene.focus);
    scene.lens.mode = LensMode::cutaway;
    scene.lens.radius_mm = 400.0;
    const Rendered as_focus = render(scene);
    EXPECT_EQ(as_context.picture.rgba, as_focus.picture.rgba) << context << " " << focus;
    int held = 0;
    for (std::size_t i = 0; i < as_context.surfaces[kContext].size(); ++i) {
      const glm::vec4& surface = as_context.surfaces[kContext][i];
      if (surface.w < 0.0F) continue;
      ASSERT_EQ(surface, as_focus.surfaces[kFocus][i]);
      ++held;
    }
    EXPECT_GT(held, 3000);
  }
}

/// The first of both branches' events, from two pictures with one branch each.
TEST(Branches, OnePassIsTheNearerOfTwoPasses) {
  for (const char* cap : {"flat", "gradient", "open"}) {
    Json document = shells_scene(1.0, 1.0);
    document["lens"]["cap"] = cap;
    const Scene both = resolved(document);
    Scene context_alone = both;
    context_alone.focus.surface.band = {5000.0};
    Scene focus_alone = both;
    focus_alone.context.surface.band = {5000.0};
    const auto one_pass = render(both).surfaces;
    const auto context = render(context_alone).surfaces[kContext];
    const auto focus = render(focus_alone).surfaces[kFocus];
    std::array<int, 3> held{};
    for (std::size_t i = 0; i < context.size(); ++i) {
      const float c = context[i].w;
      const float f = focus[i].w;
      const bool is_focus = f >= 0.0F && (c < 0.0F || f < c);
      const bool is_context = c >= 0.0F && !is_focus;
      ASSERT_EQ(one_pass[kFocus][i].w >= 0.0F, is_focus) << cap << " " << i;
      ASSERT_EQ(one_pass[kContext][i].w >= 0.0F, is_context) << cap << " " << i;
      const BranchIndex branch = is_focus ? kFocus : kContext;
      const glm::vec4& expected = is_focus ? focus[i] : context[i];
      ASSERT_TRUE((!is_focus && !is_context) || one_pass[branch][i] == expected) << cap << " " << i;
      ++held[is_focus ? 0 : is_context ? 1 : 2];
    }
    for (const int pixels : held) EXPECT_GT(pixels, 300) << cap;
  }
}

}  // namespace
}  // namespace cutaway::test
