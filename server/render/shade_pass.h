// Second stage: one branch's surface into colour.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "gl/program.h"
#include "render/gpu_volume.h"
#include "render/shading/shading_model.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/scene.h"

namespace cutaway {

/// How a branch's points are coloured.
struct LitShading {
  Module shading;
  glm::vec3 light_direction{0.0F};  ///< unit, towards the light, patient space
  bool operator==(const LitShading&) const = default;
};

/// How strongly light that is kept away is drawn.
struct Relief {
  std::uint64_t reach_version = 0;  ///< of the light's reach
  double occlusion_strength = 0.0;
  glm::dvec3 occlusion_colour{0.0};
  double shadow_strength = 0.0;
  bool operator==(const Relief&) const = default;
};

/// What is drawn of the cavity.
struct CavityWall {
  Wall wall;
  bool section = false;  ///< cut faces in the colours of tissue
  ValueBand context;
  glm::dvec3 centre_mm{0.0};  ///< of the lens
  double radius_mm = 0.0;
  bool operator==(const CavityWall&) const = default;
};

struct ShadeKey {
  std::uint64_t surface_version = 0;  ///< of the ray cast or the normals, whose rays are these
  ViewRays rays{};
  LitShading lit;
  std::optional<Relief> relief = {};
  std::optional<CavityWall> wall = {};  ///< of the context alone
  double resolution_scale = 1.0;        ///< picture pixels per viewport pixel
  bool operator==(const ShadeKey&) const = default;
};

class ShadePass {
 public:
  /// The library must outlive it.
  explicit ShadePass(const gl::ShaderLibrary& shaders) : shaders_(shaders) {}
  void run(const ShadeKey& key, BranchIndex index, const GpuVolume& volume,
           const BranchBuffers& branch, const gl::Texture2D& surface, const gl::PixelRect& strip,
           int supersampling, const gl::FullscreenTriangle& triangle);

 private:
  struct Variant {
    const ShadingModel* model;
    BranchIndex branch;
    int supersampling;
    bool turns;  ///< tells the model how normals turn
    bool relief;
    bool wall;
    auto operator<=>(const Variant&) const = default;
  };
  const gl::Program& program_for(const Variant& variant);

  const gl::ShaderLibrary& shaders_;
  std::map<Variant, gl::Program> programs_;  ///< made when first drawn with
};

}  // namespace cutaway
