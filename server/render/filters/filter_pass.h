// Third stage: one filter over one branch's picture.
#pragma once

#include <map>
#include <vector>

#include "gl/framebuffer.h"
#include "render/filters/image_filter.h"
#include "render/view_buffers.h"
#include "render/view_rays.h"
#include "scene/scene.h"

namespace cutaway {

struct FilterKey {
  std::uint64_t input_version = 0;  ///< of the shading or of the filter before
  std::uint64_t shade_version = 0;  ///< of the surface and the silhouette coverage
  Module filter;                    ///< with its lengths in pixels
  double resolution_scale = 1.0;
  bool operator==(const FilterKey&) const = default;
};

/// What filter.glsl reads.
struct FilterInput {
  const gl::Texture2D& colour;      ///< the branch's picture so far
  const gl::Texture2D& silhouette;  ///< coverage as if no lens had taken anything away
  const gl::Texture2D& surface;     ///< supersampling^2 texels a pixel
  bool is_cut = false;  ///< the branch is the one that the cutaway's lens cuts: the context
  ViewRays rays{};      ///< the camera's, and where in the whole picture this part begins
};

/// Where it draws.
struct FilterTarget {
  const gl::Framebuffer& picture;
  const FilterWork& work;  ///< with at least what the filter needs
};

class FilterPass {
 public:
  explicit FilterPass(const gl::ShaderLibrary& shaders);

  static FilterPlan plan(const FilterKey& key);
  static WorkNeeds work_needs(const FilterPlan& plan);
  /// What a step draws where its picture's `region` is asked for.
  static gl::PixelRect region_of_step(const FilterStep& step, const gl::PixelRect& region,
                                      glm::ivec2 picture_size_px);

  void run(const FilterKey& key, const FilterStep& step, const FilterInput& input,
           const FilterTarget& target, const gl::PixelRect& strip,
           const gl::FullscreenTriangle& triangle) const;

 private:
  struct Entry {
    const ImageFilter* filter;
    std::vector<gl::Program> programs;
  };
  std::map<std::string, Entry, std::less<>> programs_;
};

}  // namespace cutaway
