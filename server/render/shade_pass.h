// Second stage: one branch's surface into colour.
#pragma once

#include <vector>

#include "gl/program.h"
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

struct ShadeKey {
  std::uint64_t surface_version = 0;  ///< of the ray cast, whose rays are these
  ViewRays rays{};
  LitShading lit;
  double resolution_scale = 1.0;  ///< picture pixels per viewport pixel
  bool operator==(const ShadeKey&) const = default;
};

class ShadePass {
 public:
  explicit ShadePass(const gl::ShaderLibrary& shaders);
  void run(const ShadeKey& key, BranchIndex index, const BranchBuffers& branch,
           const gl::PixelRect& strip, int supersampling,
           const gl::FullscreenTriangle& triangle) const;

 private:
  struct Entry {
    const ShadingModel* model;
    BranchIndex branch;
    int supersampling;
    bool turns;  ///< tells the model how normals turn
    gl::Program program;
  };
  void add_programs(const gl::ShaderLibrary& shaders, const ShadingModel& model, bool turns);
  const Entry& find_entry(const ShadeKey& key, BranchIndex branch, int supersampling) const;
  std::vector<Entry> programs_;
};

}  // namespace cutaway
