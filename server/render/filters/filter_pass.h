// Third stage: one filter over one branch's picture.
#pragma once

#include <map>

#include "gl/framebuffer.h"
#include "render/filters/image_filter.h"
#include "scene/scene.h"

namespace cutaway {

struct FilterKey {
  std::uint64_t input_version = 0;  ///< of the shading or of the filter before
  std::uint64_t shade_version = 0;  ///< of the surface and the silhouette coverage
  Module filter;
  double resolution_scale = 1.0;
  bool operator==(const FilterKey&) const = default;
};

/// What shaders/filter.glsl reads.
struct FilterInput {
  const gl::Texture2D& colour;      ///< the branch's picture so far
  const gl::Texture2D& silhouette;  ///< coverage as if no lens had taken anything away
  const gl::Texture2D& surface;     ///< supersampling^2 texels a pixel
  bool is_cut = false;  ///< the branch is the one that the cutaway's lens cuts: the context
};

class FilterPass {
 public:
  explicit FilterPass(const gl::ShaderLibrary& shaders);
  void run(const FilterKey& key, const FilterInput& input, const gl::Framebuffer& target,
           const gl::PixelRect& strip, const gl::FullscreenTriangle& triangle) const;

 private:
  struct Entry {
    const ImageFilter* filter;
    gl::Program program;
  };
  std::map<std::string, Entry, std::less<>> programs_;
};

}  // namespace cutaway
