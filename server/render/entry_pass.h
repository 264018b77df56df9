// Before the rays: where each of them first comes to a part of the volume that holds something.
#pragma once

#include <array>

#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"

namespace cutaway {

struct EntryKey {
  VolumeIdentity volume;
  ViewRays rays{};
  std::array<ValueBand, kBranches> bands;
  /// False where the eye is in the volume, whose faces may then lie behind it, and where nothing is
  /// to be skipped: every ray then starts at the volume's box.
  bool is_used = false;
  float farthest_mm = 0.0F;  ///< orthographic: depth of the box' farthest corner
  bool operator==(const EntryKey&) const = default;
};

EntryKey entry_key(const GpuVolume& volume, const ViewRays& rays,
                   const std::array<ValueBand, kBranches>& bands, bool skip_empty_space);

/// Rasterises the faces around the blocks that hold something. A pixel that they leave out has no
/// ray cast for it at all.
class EntryPass {
 public:
  explicit EntryPass(const gl::ShaderLibrary& shaders);
  void run(const EntryKey& key, GpuVolume& volume, const ViewBuffers& buffers) const;

 private:
  gl::Program program_;
};

}  // namespace cutaway
