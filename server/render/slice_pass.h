// Draws a slice of the volume into the picture: the only stage of a slice before its conversion.
#pragma once

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/view_rays.h"

namespace cutaway {

/// All that a slice's picture depends on.
struct SliceKey {
  VolumeIdentity volume;
  ViewRays rays;  ///< orthographic, from the plane on
  Window window;  ///< physical values
  int supersampling = 1;
  bool operator==(const SliceKey&) const = default;
};

SliceKey slice_key(const Scene& scene, const GpuVolume& volume, const RenderSettings& settings);

/// Values are interpolated linearly between voxel centres, and drawn by window and level (DICOM
/// PS3.3 C.11.2.1.3.2, LINEAR_EXACT). Beside the volume the picture is black.
class SlicePass {
 public:
  explicit SlicePass(const gl::ShaderLibrary& shaders);
  void run(const SliceKey& key, const GpuVolume& volume, const gl::Framebuffer& target,
           const gl::PixelRect& strip, const gl::FullscreenTriangle& triangle) const;

 private:
  gl::Program program_;
};

}  // namespace cutaway
