#include "support/gpu_harness.h"

#include <gtest/gtest.h>

#include "render/loaded_facts.h"
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
  return {settings.picture_size_px, std::move(readback.finish().at(0))};
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

void expect_like_reference(const std::string& name, const Scene& scene,
                           const std::shared_ptr<const LoadedVolume>& volume,
                           const RenderSettings& settings, const Tolerance& tolerance) {
  const BytePicture actual = GpuHarness::instance().render(scene, volume, settings);
  const auto reference = reference::render(scene, volume->volume,
                                           {.picture_size_px = settings.picture_size_px,
                                            .resolution_scale = settings.resolution_scale,
                                            .supersampling = settings.supersampling,
                                            .step_voxels = settings.step_voxels});
  const BytePicture expected = to_bytes(reference.picture);
  const PictureDifference difference = compare(actual, expected);
  std::printf("%s: mean %.4f/255, maximum %d/255, %.3f %% of pixels above 2/255\n", name.c_str(),
              difference.mean, difference.maximum, 100.0 * difference.share_above_2);
  const bool close = difference.mean <= tolerance.mean &&
                     difference.share_above_2 <= tolerance.share_above_2 &&
                     difference.maximum <= tolerance.maximum;
  EXPECT_TRUE(close) << name << ": see " << (close ? "" : save_evidence(name, actual, expected));
}

}  // namespace cutaway::test
