#include "render/view_buffers.h"

namespace cutaway {

namespace {

ColourTarget colour_target(GLenum format, glm::ivec2 size_px,
                           const gl::Texture2D* depth = nullptr) {
  ColourTarget target;
  target.texture = gl::Texture2D(format, size_px, gl::Filtering::nearest);
  target.framebuffer = gl::Framebuffer({&target.texture}, depth);
  return target;
}

}  // namespace

FilterSums filter_sums(glm::ivec2 picture_size_px, int reach_px) {
  const glm::ivec2 windows_px = picture_size_px + reach_px;
  const glm::ivec2 rows_px = windows_px + glm::ivec2(0, reach_px);
  FilterSums sums{.colour_sums = {GL_RGBA32F, rows_px, gl::Filtering::nearest},
                  .square_sums = {GL_R32F, rows_px, gl::Filtering::nearest},
                  .windows = {GL_RGBA32F, windows_px, gl::Filtering::nearest}};
  sums.rows_target = gl::Framebuffer({&sums.colour_sums, &sums.square_sums});
  sums.windows_target = gl::Framebuffer({&sums.windows});
  return sums;
}

ViewBuffers::ViewBuffers(glm::ivec2 picture_size_px, int supersampling)
    : picture_size_px_(picture_size_px), supersampling_(supersampling) {
  picture = colour_target(GL_RGBA8, picture_size_px);
}

void ViewBuffers::prepare_rays() {
  if (entry.name() != 0) return;
  entry = gl::Texture2D(GL_R32F, surface_size_px(), gl::Filtering::nearest);
  entry_depth = gl::Texture2D(GL_DEPTH_COMPONENT32F, surface_size_px(), gl::Filtering::nearest);
  for (BranchBuffers& branch : branches) {
    branch.surface = gl::Texture2D(GL_RGBA32F, surface_size_px(), gl::Filtering::nearest);
    branch.shaded = gl::Texture2D(GL_RGBA16F, picture_size_px_, gl::Filtering::nearest);
    branch.silhouette = gl::Texture2D(GL_R8, picture_size_px_, gl::Filtering::nearest);
    branch.shade_target = gl::Framebuffer({&branch.shaded, &branch.silhouette}, picture_depth());
  }
  entry_target = gl::Framebuffer({&entry}, &entry_depth);
  surface_target =
      gl::Framebuffer({&branches[kContext].surface, &branches[kFocus].surface}, &entry_depth);
}

const gl::Texture2D* ViewBuffers::picture_depth() const {
  return supersampling_ == 1 ? &entry_depth : nullptr;
}

bool ViewBuffers::fits(const RenderSettings& settings) const {
  return picture_size_px_ == settings.picture_size_px && supersampling_ == settings.supersampling;
}

glm::ivec2 ViewBuffers::chroma_size_px(PixelLayout layout) const {
  return layout == PixelLayout::yuv420 ? (picture_size_px_ + 1) / 2 : picture_size_px_;
}

glm::ivec2 ViewBuffers::luma_size_px(PixelLayout layout) const {
  return layout == PixelLayout::yuv420 ? chroma_size_px(layout) * 2 : picture_size_px_;
}

ColourTarget& ViewBuffers::filtered(BranchIndex branch, std::size_t index) {
  auto& targets = branches[branch].filtered;
  while (targets.size() <= index)
    targets.push_back(colour_target(GL_RGBA16F, picture_size_px_, picture_depth()));
  return targets[index];
}

std::uint64_t ViewBuffers::bytes() const {
  std::uint64_t sum = picture.texture.bytes() + entry.bytes() + entry_depth.bytes() +
                      luma.texture.bytes() + cb.bytes() + cr.bytes() + sums_.colour_sums.bytes() +
                      sums_.square_sums.bytes() + sums_.windows.bytes();
  for (const BranchBuffers& branch : branches) {
    sum += branch.surface.bytes() + branch.layers.bytes() + branch.shaded.bytes() +
           branch.silhouette.bytes();
    for (const ColourTarget& target : branch.filtered) sum += target.texture.bytes();
  }
  return sum;
}

void ViewBuffers::prepare_sums(int reach_px) {
  if (reach_px == sums_reach_px_) return;
  sums_ = reach_px == 0 ? FilterSums() : filter_sums(picture_size_px_, reach_px);
  sums_reach_px_ = reach_px;
}

void ViewBuffers::prepare_layers() {
  if (branches[kContext].layers.name() != 0) return;
  for (BranchBuffers& branch : branches)
    branch.layers = gl::Texture2D(GL_RGBA32F, surface_size_px(), gl::Filtering::nearest);
  layers_target = gl::Framebuffer({&branches[kContext].surface, &branches[kFocus].surface,
                                   &branches[kContext].layers, &branches[kFocus].layers},
                                  &entry_depth);
}

void ViewBuffers::prepare_planes(PixelLayout layout) {
  if (layout == PixelLayout::rgba) return;
  if (cb.size_px() == chroma_size_px(layout) && luma.texture.size_px() == luma_size_px(layout))
    return;
  luma = colour_target(GL_R8, luma_size_px(layout));
  cb = gl::Texture2D(GL_R8, chroma_size_px(layout), gl::Filtering::nearest);
  cr = gl::Texture2D(GL_R8, chroma_size_px(layout), gl::Filtering::nearest);
  chroma_target = gl::Framebuffer({&cb, &cr});
}

}  // namespace cutaway
