// Between the ray cast and shading: a branch's normals, taken anew of the volume under a Gaussian,
// or of its cubic reconstruction.
#pragma once

#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/scene.h"

namespace cutaway {

struct NormalsKey {
  std::uint64_t surface_version = 0;  ///< of the ray cast, whose volume, rays and band these are
  ViewRays rays{};
  double scale_mm = 0.0;
  Reconstruction reconstruction = Reconstruction::linear;
  ValueBand band;  ///< of the branch
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
  const gl::Program& use_linear(const NormalsKey& key, const GpuVolume& volume) const;
  const gl::Program& use_cubic(const NormalsKey& key, const GpuVolume& volume) const;

  gl::Program linear_;
  gl::Program cubic_;
  gl::Program cubic_at_scale_;
};

}  // namespace cutaway
