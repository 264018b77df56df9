// First stage: rays against both branches' material.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "render/gpu_volume.h"
#include "render/shade_pass.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/lenses/funnel.h"

namespace cutaway {

/// All that the stage's buffers depend on.
struct RayCastKey {
  std::uint64_t entry_version = 0;  ///< of where the rays come to something, and of the volume
  ViewRays rays{};
  std::array<Surface, kBranches> surfaces;
  /// Where a branch lets light through, layers are coloured on the way; nothing else looks here.
  std::optional<std::array<LitShading, kBranches>> lit;
  Lens lens;  ///< only what shapes its region: what the composite alone reads is empty
  std::optional<Funnel> funnel;
  double step_voxels = 1.0;
  bool skip_empty_space = true;
  bool operator==(const RayCastKey&) const = default;

  bool is_translucent() const { return lit.has_value(); }
};

/// Opaque branches leave a surface, which is coloured later; translucent ones their layers, already
/// coloured. Source: S. Stegmaier et al., "A Simple and Flexible Volume Rendering Framework for
/// Graphics-Hardware-based Raycasting", Volume Graphics 2005; refinement after M. Hadwiger et al.,
/// "Real-Time Ray-Casting and Advanced Shading of Discrete Isosurfaces", Eurographics 2005.
class RayCastPass {
 public:
  explicit RayCastPass(const gl::ShaderLibrary& shaders);
  /// Everything as if no ray had met anything.
  static void clear(const RayCastKey& key, const ViewBuffers& buffers);
  /// Casts the rays of a strip of the surface buffers; layers must have been prepared. No ray
  /// outside of `lens` meets the lens.
  void run(const RayCastKey& key, GpuVolume& volume, const ViewBuffers& buffers,
           const gl::PixelRect& strip, const gl::PixelRect& lens,
           const gl::FullscreenTriangle& triangle) const;

 private:
  /// One for each body and mode of the lens; without a lens there is no body.
  struct Entry {
    std::string body;
    LensMode mode;
    gl::Program opaque;
    gl::Program translucent;
  };
  const Entry& entry_for(LensMode mode, const Lens& lens) const;
  void draw(const Entry& entry, const RayCastKey& key, GpuVolume& volume,
            const ViewBuffers& buffers, std::span<const gl::PixelRect> parts,
            const gl::FullscreenTriangle& triangle) const;

  std::vector<Entry> programs_;
};

}  // namespace cutaway
