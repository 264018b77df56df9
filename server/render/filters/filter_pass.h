// Third stage: one filter over one branch's picture.
#pragma once

#include <map>

#include "gl/framebuffer.h"
#include "render/filters/image_filter.h"
#include "scene/scene.h"

namespace cutaway {

struct FilterKey {
  std::uint64_t input_version = 0;  ///< of the shading or of the filter before
  std::uint64_t shade_version = 0;  ///< of the silhouette coverage
  Module filter;
  double resolution_scale = 1.0;
  bool operator==(const FilterKey&) const = default;
};

class FilterPass {
 public:
  explicit FilterPass(const gl::ShaderLibrary& shaders);
  void run(const FilterKey& key, const gl::Texture2D& colour, const gl::Texture2D& silhouette,
           const gl::Framebuffer& target, const gl::FullscreenTriangle& triangle);

 private:
  struct Entry {
    const ImageFilter* filter;
    gl::Program program;
  };
  std::map<std::string, Entry, std::less<>> programs_;
};

}  // namespace cutaway
