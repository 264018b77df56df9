// Second stage: one branch's surface into colour.
#pragma once

#include <map>

#include "render/shading/shading_model.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/scene.h"

namespace cutaway {

struct ShadeKey {
  std::uint64_t surface_version = 0;  ///< of the ray cast, whose rays are these
  ViewRays rays{};
  Module shading;
  glm::vec3 light_direction{0.0F};  ///< unit, towards the light, patient space
  bool operator==(const ShadeKey&) const = default;
};

class ShadePass {
 public:
  explicit ShadePass(const gl::ShaderLibrary& shaders);
  void run(const ShadeKey& key, const BranchBuffers& branch, int supersampling,
           const gl::FullscreenTriangle& triangle);

 private:
  struct Entry {
    const ShadingModel* model;
    gl::Program program;
  };
  std::map<std::string, Entry, std::less<>> programs_;
};

}  // namespace cutaway
