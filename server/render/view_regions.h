// Where in a picture anything of a branch can be: stages draw there only.
#pragma once

#include <array>
#include <vector>

#include "gl/framebuffer.h"
#include "render/view_buffers.h"
#include "scene/scene.h"
#include "volume/geometry.h"

namespace cutaway {

/// In pixels of the picture, each with a margin of what a 3 x 3 filter reads beside the branch.
struct ViewRegions {
  gl::PixelRect volume;
  std::array<gl::PixelRect, kBranches> branches;  ///< the focus': empty where there is no lens
};

/// `part`: of the volume, beside which there is nothing to draw.
ViewRegions view_regions(const Scene& scene, const VolumeGeometry& part,
                         const RenderSettings& settings);

gl::PixelRect common_part(const gl::PixelRect& a, const gl::PixelRect& b);

/// What `outer` has beside `inner`: four parts at most, none of them empty.
std::vector<gl::PixelRect> parts_around(const gl::PixelRect& outer, const gl::PixelRect& inner);

/// The same region of a picture that has `factor` times the pixels each way.
gl::PixelRect scaled(const gl::PixelRect& region, int factor);

}  // namespace cutaway
