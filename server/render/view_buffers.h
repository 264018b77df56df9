// What one view keeps on the device between frames.
#pragma once

#include <array>
#include <deque>
#include <glm/glm.hpp>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/filters/filter_work.h"
#include "render/render_settings.h"

namespace cutaway {

/// Index of a branch in arrays here and in the shaders.
enum BranchIndex : std::size_t { kContext = 0, kFocus = 1 };
inline constexpr std::size_t kBranches = 2;

/// Of a surface buffer's texel: the ray left the volume. See shaders/branches.glsl.
inline constexpr glm::vec4 kNothingMet(0.0F, 0.0F, 0.0F, -1.0F);

/// One colour texture with its framebuffer.
struct ColourTarget {
  gl::Texture2D texture;
  gl::Framebuffer framebuffer;
};

struct BranchBuffers {
  gl::Texture2D surface;     ///< RGBA32F, see shaders/branches.glsl
  gl::Texture2D calmed;      ///< the same with normals at a scale; not there where nobody asks
  ColourTarget reach_raw;    ///< RG16F, of light; a texel a pixel, see shaders/light_reach.frag
  ColourTarget reach;        ///< RG16F, the same without its pattern
  gl::Texture2D layers;      ///< RGBA32F, of translucent material: premultiplied colour, opacity
  gl::Texture2D shaded;      ///< RGBA16F: display-encoded colour, coverage
  gl::Texture2D silhouette;  ///< R8: coverage as if no lens had taken anything away
  gl::Framebuffer shade_target;
  gl::Framebuffer calmed_target;
  std::deque<ColourTarget>
      filtered;  ///< one for each filter, kept so that an unchanged one need not run again
};

/// What is drawn in them, as far as their size goes.
struct BufferNeeds {
  glm::ivec2 picture_size_px{0};
  int supersampling = 1;
  PixelLayout layout = PixelLayout::rgba;
  bool casts_rays = true;
  bool is_translucent = false;
  std::array<std::size_t, kBranches> filters{};
  std::array<bool, kBranches> calmed{};
  std::array<bool, kBranches> reach{};
  WorkNeeds work;  ///< of the filters' steps
};

/// What ViewBuffers take on the device once all of it is drawn.
std::uint64_t bytes_for(const BufferNeeds& needs);
/// The longest side of their textures.
int longest_side_px(const BufferNeeds& needs);

/// Render thread only.
class ViewBuffers {
 public:
  ViewBuffers(glm::ivec2 picture_size_px, int supersampling);

  bool fits(const RenderSettings& settings) const;
  glm::ivec2 picture_size_px() const { return picture_size_px_; }
  int supersampling() const { return supersampling_; }
  glm::ivec2 surface_size_px() const { return picture_size_px_ * supersampling_; }

  /// What all of them take on the device.
  std::uint64_t bytes() const;

  /// Makes sure that each branch has a target for its filter number `index`.
  ColourTarget& filtered(BranchIndex branch, std::size_t index);
  /// Makes sure that there is what rays need: a slice casts none.
  void prepare_rays();
  /// Makes sure that filters have just that.
  void prepare_work(const WorkNeeds& needs);
  const FilterWork& work() const { return work_; }
  /// Makes sure that both branches' layers and their target exist.
  void prepare_layers();
  /// Makes sure that there is room for a branch's normals at a scale, or for the light's reach.
  void prepare_calmed(BranchIndex branch);
  void prepare_reach(BranchIndex branch);
  /// Makes sure that the planes of `layout` exist.
  void prepare_planes(PixelLayout layout);

  std::array<BranchBuffers, kBranches> branches;
  gl::Texture2D entry;        ///< R32F, mm along the ray where it comes to something; surface size
  gl::Texture2D entry_depth;  ///< says the same to the depth test
  gl::Framebuffer entry_target;
  gl::Framebuffer surface_target;  ///< both branches' surfaces
  gl::Framebuffer layers_target;   ///< both branches' surfaces, then their layers
  ColourTarget picture;            ///< RGBA8
  ColourTarget luma;               ///< R8
  gl::Texture2D cb;
  gl::Texture2D cr;
  gl::Framebuffer chroma_target;

 private:
  /// The entry's depth where it has a texel a pixel: stages after the ray cast draw only where a
  /// ray can have met something.
  const gl::Texture2D* picture_depth() const;

  glm::ivec2 picture_size_px_;
  int supersampling_;
  FilterWork work_;
};

}  // namespace cutaway
