// First stage: rays against both branches' surfaces.
#pragma once

#include <map>

#include "render/gpu_volume.h"
#include "render/lenses/lens_shape.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"

namespace cutaway {

/// All that the surface buffers depend on.
struct RayCastKey {
  const LoadedVolume* volume = nullptr;
  ViewRays rays{};
  double context_iso_value = 0.0;
  double focus_iso_value = 0.0;
  Lens lens;
  double step_voxels = 1.0;
  bool skip_empty_space = true;
  bool operator==(const RayCastKey&) const = default;
};

/// Source: S. Stegmaier et al., "A Simple and Flexible Volume Rendering Framework for
/// Graphics-Hardware-based Raycasting", Volume Graphics 2005; refinement after M. Hadwiger et al.,
/// "Real-Time Ray-Casting and Advanced Shading of Discrete Isosurfaces", Eurographics 2005.
class RayCastPass {
 public:
  explicit RayCastPass(const gl::ShaderLibrary& shaders);
  void run(const RayCastKey& key, GpuVolume& volume, const ViewBuffers& buffers,
           const gl::FullscreenTriangle& triangle);

 private:
  struct Entry {
    const LensShape* shape;
    gl::Program program;
  };
  std::map<std::string, Entry, std::less<>> programs_;  ///< by lens shape
};

}  // namespace cutaway
