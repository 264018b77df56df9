// A context and a pipeline for tests, and the comparison of their pictures with the reference's.
#pragma once

#include <memory>

#include "gl/context.h"
#include "render/frame_pipeline.h"
#include "scene/scene.h"
#include "support/picture_difference.h"
#include "support/reference_renderer.h"

namespace cutaway::test {

/// One for each test program, on the main thread; GL errors end the program.
class GpuHarness {
 public:
  static GpuHarness& instance();

  const gl::Context& context() const { return *context_; }
  FramePipeline& pipeline() { return pipeline_; }

  BytePicture render(const Scene& scene, const std::shared_ptr<const LoadedVolume>& volume,
                     const RenderSettings& settings);
  /// The view that render used last.
  ViewState& view() { return view_; }

 private:
  GpuHarness();
  std::unique_ptr<gl::Context> context_;
  FramePipeline pipeline_;
  ViewState view_;
  /// The view knows its volume by its address, which must not be another's meanwhile.
  std::shared_ptr<const LoadedVolume> shown_;
};

std::shared_ptr<const LoadedVolume> load(Volume volume);

/// A complete scene from a partial document.
Scene scene_for(const Json& document, const std::shared_ptr<const LoadedVolume>& volume,
                Viewport viewport);

/// Full size, rgba, one ray a pixel.
RenderSettings settings_for(const Scene& scene);

/// With which the reference draws the same.
reference::Settings reference_settings(const LoadedVolume& volume, const RenderSettings& settings);

struct Tolerance {
  double mean = 0.0;           ///< in 1/255
  double share_above_2 = 0.0;  ///< of the pixels
  int maximum = 255;           ///< in 1/255
  /// Of the pixels: those with a ray that meets a branch on one side only, which are left out of
  /// the other three as far as filters carry them.
  double share_of_disagreements = 0.0;
};

/// How near the scene's picture has to be to the reference's: to rounding, but where it holds a
/// decision that rounding may turn.
Tolerance tolerance_for(const Scene& scene);

/// Renders both and expects the difference within the tolerance; keeps the pictures where it is
/// not.
void expect_like_reference(const std::string& name, const Scene& scene,
                           const std::shared_ptr<const LoadedVolume>& volume,
                           const RenderSettings& settings, const Tolerance& tolerance);

}  // namespace cutaway::test
