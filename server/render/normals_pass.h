// Between the ray cast and shading: a branch's normals, taken anew of the volume under a Gaussian.
#pragma once

#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"

namespace cutaway {

struct NormalsKey {
  std::uint64_t surface_version = 0;  ///< of the ray cast, whose volume and rays are these
  ViewRays rays{};
  double scale_mm = 0.0;
  bool operator==(const NormalsKey&) const = default;
};

class NormalsPass {
 public:
  explicit NormalsPass(const gl::ShaderLibrary& shaders);
  /// Draws `branch.calmed` from `branch.surface`; `strip` is of rays.
  void run(const NormalsKey& key, const GpuVolume& volume, const BranchBuffers& branch,
           const gl::PixelRect& strip, int supersampling,
           const gl::FullscreenTriangle& triangle) const;

 private:
  gl::Program fine_;
  gl::Program coarse_;
};

}  // namespace cutaway
