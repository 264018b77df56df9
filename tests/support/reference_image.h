// Pictures of the reference renderer: doubles, one struct a pixel.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace cutaway::reference {

/// Display-encoded colour, not premultiplied, with its coverage, and the coverage as if no lens had
/// cut anything away; means over the rays that meet the branch of its surface there.
struct BranchPixel {
  glm::dvec3 colour{0.0};
  double coverage = 0.0;
  double silhouette_coverage = 0.0;
  glm::dvec3 normal{0.0};
  double depth_mm = 0.0;
  double behind_lens = 0.0;     ///< share of them
  double nearest_mm = 0.0;      ///< depth of the nearest of them
  glm::dvec3 seen_normal{0.0};  ///< the normal's shares to the right, down and towards the camera
};

/// Rows top first.
template <typename Pixel>
struct Image {
  glm::ivec2 size_px{0};
  std::vector<Pixel> pixels;

  explicit Image(glm::ivec2 size)
      : size_px(size), pixels(static_cast<std::size_t>(size.x) * size.y) {}
  bool contains(glm::ivec2 at) const {
    return at.x >= 0 && at.y >= 0 && at.x < size_px.x && at.y < size_px.y;
  }
  Pixel& at(glm::ivec2 p) { return pixels[static_cast<std::size_t>(p.y) * size_px.x + p.x]; }
  const Pixel& at(glm::ivec2 p) const {
    return pixels[static_cast<std::size_t>(p.y) * size_px.x + p.x];
  }
  const Pixel& clamped(glm::ivec2 p) const { return at(glm::clamp(p, glm::ivec2(0), size_px - 1)); }
};

using BranchImage = Image<BranchPixel>;
using ColourImage = Image<glm::dvec3>;

}  // namespace cutaway::reference
