// Between the ray cast and shading: how much light comes to a branch's surface.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/lenses/funnel.h"
#include "scene/scene.h"

namespace cutaway {

/// Lengths in mm; none of them depends on how strongly it is drawn.
struct LightKey {
  std::uint64_t surface_version = 0;  ///< whose normals and places these are
  ViewRays rays{};
  std::array<ValueBand, kBranches> bands;  ///< what is in the way
  Lens lens;                               ///< mode, shape and place alone
  std::optional<Funnel> funnel;
  glm::vec3 light_direction{0.0F};  ///< unit, towards the light, patient space
  float start_mm = 0.0F;
  float range_mm = 0.0F;
  float near_share = 0.0F;
  float shadow_softness_degrees = 0.0F;
  float shadow_range_mm = 0.0F;
  LightQuality quality;  ///< no directions, or no shadow rays, where nobody asks for them
  bool operator==(const LightKey&) const = default;

  bool is_asked() const { return quality.directions > 0 || quality.shadow_rays > 0; }
};

/// Step 0 marches the rays, step 1 takes their pattern away.
class LightPass {
 public:
  static constexpr int kSteps = 2;
  /// How far step 1 reads beside a pixel.
  static constexpr int kReach_px = 2;

  explicit LightPass(const gl::ShaderLibrary& shaders);
  void run(const LightKey& key, int step, BranchIndex index, const GpuVolume& volume,
           const BranchBuffers& branch, const gl::Texture2D& surface, const gl::PixelRect& strip,
           int supersampling, const gl::FullscreenTriangle& triangle) const;

 private:
  struct Entry {
    BranchIndex branch;
    std::string body;  ///< file of the lens' body; empty: no cutaway
    gl::Program program;
  };
  const gl::Program& program_for(const LightKey& key, BranchIndex branch) const;
  void march(const LightKey& key, BranchIndex index, const GpuVolume& volume,
             const gl::Texture2D& surface, int supersampling) const;
  void blur(const LightKey& key, const BranchBuffers& branch, const gl::Texture2D& surface,
            int supersampling) const;

  std::vector<Entry> programs_;
  gl::Program blur_;
};

}  // namespace cutaway
