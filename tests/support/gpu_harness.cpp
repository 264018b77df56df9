#include "support/gpu_harness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/filters/filter_pass.h"
#include "render/loaded_facts.h"
#include "render/shading/shading_registry.h"
#include "scene/relative_lengths.h"
#include "scene/resolve.h"

namespace cutaway::test {

GpuHarness::GpuHarness() : context_(gl::Context::create({.debug_output = true})) {
  std::printf("OpenGL renderer: %s\n", context_->renderer().c_str());
}

GpuHarness& GpuHarness::instance() {
  static GpuHarness harness;
  return harness;
}

BytePicture GpuHarness::render(const Scene& scene,
                               const std::shared_ptr<const LoadedVolume>& volume,
                               const RenderSettings& settings) {
  GpuVolume gpu_volume(volume, context_->max_3d_texture_size());
  gpu_volume.upload_rest();
  pipeline_.render(view_, scene, gpu_volume, settings);
  shown_ = volume;
  gl::PixelReadback readback;
  FramePipeline::start_readback(view_, PixelLayout::rgba, readback);
  const auto planes = readback.finish();
  const auto rgba = planes.at(0).bytes();
  return {settings.picture_size_px, {rgba.begin(), rgba.end()}};
}

std::shared_ptr<const LoadedVolume> load(Volume volume) {
  return derive_loaded_volume(std::move(volume), {}, {});
}

Scene scene_for(const Json& document, const std::shared_ptr<const LoadedVolume>& volume,
                Viewport viewport) {
  return resolve_scene(document, facts_of(volume), viewport);
}

RenderSettings settings_for(const Scene& scene) {
  return {.picture_size_px = {scene.viewport.width_px, scene.viewport.height_px}};
}

namespace {

/// How far a pixel's colour reaches through what is done to a branch's picture, px.
int reach_of_branch(const Branch& branch, const Scene& scene, double resolution_scale) {
  int reach = reads_turning(in_pixels(branch.shading, scene.viewport.height_px)) ? 1 : 0;
  if (branch.occlusion.strength > 0.0 || branch.shadow.strength > 0.0) reach = LightPass::kReach_px;
  for (const Module& filter : branch.filters)
    reach += FilterPass::plan({.filter = in_pixels(filter, scene.viewport.height_px),
                               .resolution_scale = resolution_scale})
                 .reach_px;
  return reach;
}

/// As branches.glsl marks it.
bool is_behind_lens(const glm::vec4& surface) {
  const int length = static_cast<int>(std::lround(glm::length(glm::vec3(surface))));
  return length == 2 || length == 4;  // see shaders/branches.glsl
}

/// The pixels with a ray that meets a branch on one side only: it grazes a surface or an edge, and
/// falls to one side or the other by rounding. Nothing can be said of their colour, nor of what
/// filters make of it beside them.
class Disagreements {
 public:
  Disagreements(const ViewState& view, const reference::Image<reference::RayLayers>& rays,
                glm::ivec2 picture_size_px)
      : size_px_(picture_size_px),
        disagrees_(static_cast<std::size_t>(picture_size_px.x) * picture_size_px.y) {
    const auto context = FramePipeline::read_surface(view, kContext);
    const auto focus = FramePipeline::read_surface(view, kFocus);
    const int supersampling = rays.size_px.x / size_px_.x;
    for (std::size_t i = 0; i < rays.pixels.size(); ++i) {
      const bool is_one = (context[i].w >= 0.0F) == rays.pixels[i].context.is_met &&
                          (focus[i].w >= 0.0F) == rays.pixels[i].focus.is_met &&
                          is_behind_lens(context[i]) == rays.pixels[i].context.is_behind_lens;
      if (is_one) continue;
      const glm::ivec2 ray(i % rays.size_px.x, i / rays.size_px.x);
      const glm::ivec2 pixel = ray / supersampling;
      disagrees_[static_cast<std::size_t>(pixel.y) * size_px_.x + pixel.x] = true;
    }
  }

  double share() const {
    return static_cast<double>(std::ranges::count(disagrees_, true)) /
           static_cast<double>(disagrees_.size());
  }

  bool is_near(glm::ivec2 pixel, int reach) const {
    const glm::ivec2 low = glm::max(pixel - reach, glm::ivec2(0));
    const glm::ivec2 high = glm::min(pixel + reach, size_px_ - 1);
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        if (disagrees_[static_cast<std::size_t>(y) * size_px_.x + x]) return true;
      }
    }
    return false;
  }

 private:
  glm::ivec2 size_px_;
  std::vector<bool> disagrees_;
};

/// `actual` with what was expected where nothing can be said.
BytePicture comparable(const BytePicture& actual, const BytePicture& expected,
                       const Disagreements& disagreements, int reach) {
  BytePicture result = actual;
  for (std::size_t i = 0; i < actual.rgba.size(); i += 4) {
    const std::size_t number = i / 4;
    const glm::ivec2 pixel(number % actual.size_px.x, number / actual.size_px.x);
    if (!disagreements.is_near(pixel, reach)) continue;
    std::copy_n(expected.rgba.begin() + static_cast<std::ptrdiff_t>(i), 4,
                result.rgba.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return result;
}

}  // namespace

// Measured: 1/255 at the most without such decisions, and no ray that disagrees. Kuwahara and its
// like choose among windows of nearly one variance, Canny's edge is the one pixel or the one beside
// it, a stroke lies along a direction that nearly flat skin hardly has, and the normal of a layer
// deep within material is that of a field that is nearly flat there: up to 43/255 at one pixel in a
// thousand. A GPU's own filter places samples to 1/256 of a voxel, which turns more of them, and
// pixels at a toon's step.
Tolerance tolerance_for(const Scene& scene) {
  if (!GpuHarness::instance().context().is_software())
    return {.mean = 0.25, .share_above_2 = 0.005, .maximum = 128, .share_of_disagreements = 0.001};
  bool decides = scene.context.surface.opacity < 1.0 || scene.focus.surface.opacity < 1.0;
  bool draws_crests = false;
  bool draws_strokes = false;
  for (const Branch* branch : {&scene.context, &scene.focus}) {
    for (const Module& filter : branch->filters) {
      decides = decides || filter.name != "sobel";
      draws_crests = draws_crests || filter.name == "canny";
      draws_strokes = draws_strokes || filter.name == "hatching";
    }
  }
  if (draws_strokes) return {.mean = 0.25, .share_above_2 = 0.01};
  if (draws_crests) return {.mean = 0.08, .share_above_2 = 0.001};
  if (decides) return {.mean = 0.08, .share_above_2 = 0.002, .maximum = 48};
  return {.mean = 0.08, .maximum = 1};
}

reference::Settings reference_settings(const LoadedVolume& volume, const RenderSettings& settings) {
  const TissueRamp ramp = tissue_ramp(volume);
  return {.picture_size_px = settings.picture_size_px,
          .resolution_scale = settings.resolution_scale,
          .supersampling = settings.supersampling,
          .step_voxels = settings.step_voxels,
          .tissues = {ramp.range, {ramp.colours.begin(), ramp.colours.end()}},
          .light = {.directions = settings.light.directions,
                    .samples = settings.light.samples,
                    .shadow_rays = settings.light.shadow_rays,
                    .shadow_samples = settings.light.shadow_samples}};
}

void expect_like_reference(const std::string& name, const Scene& scene,
                           const std::shared_ptr<const LoadedVolume>& volume,
                           const RenderSettings& settings, const Tolerance& tolerance) {
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture actual = gpu.render(scene, volume, settings);
  const auto reference =
      reference::render(scene, volume->volume, reference_settings(*volume, settings));
  const BytePicture expected = to_bytes(reference.picture);
  const Disagreements disagreements(gpu.view(), reference.rays, settings.picture_size_px);
  const int reach = std::max(reach_of_branch(scene.context, scene, settings.resolution_scale),
                             reach_of_branch(scene.focus, scene, settings.resolution_scale));
  const PictureDifference difference =
      compare(comparable(actual, expected, disagreements, reach), expected);
  std::printf(
      "%s: mean %.4f/255, maximum %d/255, %.3f %% of pixels above 2/255; rays of %.3f %% "
      "disagree\n",
      name.c_str(), difference.mean, difference.maximum, 100.0 * difference.share_above_2,
      100.0 * disagreements.share());
  const bool close = difference.mean <= tolerance.mean &&
                     difference.share_above_2 <= tolerance.share_above_2 &&
                     difference.maximum <= tolerance.maximum &&
                     disagreements.share() <= tolerance.share_of_disagreements;
  EXPECT_TRUE(close) << name << ": see " << (close ? "" : save_evidence(name, actual, expected));
}

}  // namespace cutaway::test
