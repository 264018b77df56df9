#include "render/view_buffers.h"

#include <algorithm>

namespace cutaway {

namespace {

constexpr GLenum kEntryFormat = GL_R32F;
constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT32F;
constexpr GLenum kSurfaceFormat = GL_RGBA32F;
constexpr GLenum kLayersFormat = GL_RGBA32F;
constexpr GLenum kColourFormat = GL_RGBA16F;
constexpr GLenum kSilhouetteFormat = GL_R8;
constexpr GLenum kReachFormat = GL_RG16F;
constexpr GLenum kPictureFormat = GL_RGBA8;
constexpr GLenum kPlaneFormat = GL_R8;

ColourTarget colour_target(GLenum format, glm::ivec2 size_px,
                           const gl::Texture2D* depth = nullptr) {
  ColourTarget target;
  target.texture = gl::Texture2D(format, size_px, gl::Filtering::nearest);
  target.framebuffer = gl::Framebuffer({&target.texture}, depth);
  return target;
}

}  // namespace

ViewBuffers::ViewBuffers(glm::ivec2 picture_size_px, int supersampling)
    : picture_size_px_(picture_size_px), supersampling_(supersampling) {
  picture = colour_target(kPictureFormat, picture_size_px);
}

void ViewBuffers::prepare_rays() {
  if (entry.name() != 0) return;
  entry = gl::Texture2D(kEntryFormat, surface_size_px(), gl::Filtering::nearest);
  entry_depth = gl::Texture2D(kDepthFormat, surface_size_px(), gl::Filtering::nearest);
  for (BranchBuffers& branch : branches) {
    branch.surface = gl::Texture2D(kSurfaceFormat, surface_size_px(), gl::Filtering::nearest);
    branch.shaded = gl::Texture2D(kColourFormat, picture_size_px_, gl::Filtering::nearest);
    branch.silhouette = gl::Texture2D(kSilhouetteFormat, picture_size_px_, gl::Filtering::nearest);
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

ColourTarget& ViewBuffers::filtered(BranchIndex branch, std::size_t index) {
  auto& targets = branches[branch].filtered;
  while (targets.size() <= index)
    targets.push_back(colour_target(kColourFormat, picture_size_px_, picture_depth()));
  return targets[index];
}

std::uint64_t ViewBuffers::bytes() const {
  std::uint64_t sum = picture.texture.bytes() + entry.bytes() + entry_depth.bytes() +
                      luma.texture.bytes() + cb.bytes() + cr.bytes() + work_.bytes();
  for (const BranchBuffers& branch : branches) {
    sum += branch.calmed.bytes() + branch.reach_raw.texture.bytes() + branch.reach.texture.bytes() +
           branch.surface.bytes() + branch.layers.bytes() + branch.shaded.bytes() +
           branch.silhouette.bytes();
    for (const ColourTarget& target : branch.filtered) sum += target.texture.bytes();
  }
  return sum;
}

void ViewBuffers::prepare_work(const WorkNeeds& needs) {
  if (needs == work_.needs()) return;
  work_ = FilterWork(needs, picture_size_px_);
}

void ViewBuffers::prepare_layers() {
  if (branches[kContext].layers.name() != 0) return;
  for (BranchBuffers& branch : branches)
    branch.layers = gl::Texture2D(kLayersFormat, surface_size_px(), gl::Filtering::nearest);
  layers_target = gl::Framebuffer({&branches[kContext].surface, &branches[kFocus].surface,
                                   &branches[kContext].layers, &branches[kFocus].layers},
                                  &entry_depth);
}

void ViewBuffers::prepare_calmed(BranchIndex branch) {
  BranchBuffers& buffers = branches[branch];
  if (buffers.calmed.name() != 0) return;
  buffers.calmed = gl::Texture2D(kSurfaceFormat, surface_size_px(), gl::Filtering::nearest);
  buffers.calmed_target = gl::Framebuffer({&buffers.calmed}, &entry_depth);
}

void ViewBuffers::prepare_reach(BranchIndex branch) {
  BranchBuffers& buffers = branches[branch];
  if (buffers.reach.texture.name() != 0) return;
  for (ColourTarget* target : {&buffers.reach_raw, &buffers.reach})
    *target = colour_target(kReachFormat, picture_size_px_, picture_depth());
}

void ViewBuffers::prepare_planes(PixelLayout layout) {
  if (layout == PixelLayout::rgba) return;
  const std::vector<PlaneShape> shapes = plane_shapes(layout, picture_size_px_);
  if (cb.size_px() == shapes[1].size_px && luma.texture.size_px() == shapes[0].size_px) return;
  luma = colour_target(kPlaneFormat, shapes[0].size_px);
  cb = gl::Texture2D(kPlaneFormat, shapes[1].size_px, gl::Filtering::nearest);
  cr = gl::Texture2D(kPlaneFormat, shapes[2].size_px, gl::Filtering::nearest);
  chroma_target = gl::Framebuffer({&cb, &cr});
}

namespace {

std::uint64_t bytes(GLenum format, glm::ivec2 size_px) {
  return std::uint64_t(size_px.x) * size_px.y * gl::texel_bytes(format);
}

std::uint64_t ray_bytes(const BufferNeeds& needs) {
  const glm::ivec2 rays_px = needs.picture_size_px * needs.supersampling;
  const std::uint64_t layers = needs.is_translucent ? bytes(kLayersFormat, rays_px) : 0;
  return bytes(kEntryFormat, rays_px) + bytes(kDepthFormat, rays_px) +
         kBranches * (bytes(kSurfaceFormat, rays_px) + layers);
}

std::uint64_t branch_bytes(const BufferNeeds& needs) {
  std::uint64_t sum = 0;
  for (const std::size_t filters : needs.filters)
    sum += bytes(kSilhouetteFormat, needs.picture_size_px) +
           (1 + filters) * bytes(kColourFormat, needs.picture_size_px);
  return sum;
}

std::uint64_t light_bytes(const BufferNeeds& needs) {
  std::uint64_t sum = 0;
  for (std::size_t branch = 0; branch < kBranches; ++branch) {
    if (needs.calmed[branch])
      sum += bytes(kSurfaceFormat, needs.picture_size_px * needs.supersampling);
    if (needs.reach[branch]) sum += 2 * bytes(kReachFormat, needs.picture_size_px);
  }
  return sum;
}

std::uint64_t plane_bytes(const BufferNeeds& needs) {
  std::uint64_t sum = 0;
  if (needs.layout == PixelLayout::rgba) return sum;
  for (const PlaneShape& shape : plane_shapes(needs.layout, needs.picture_size_px))
    sum += bytes(kPlaneFormat, shape.size_px);
  return sum;
}

}  // namespace

std::uint64_t bytes_for(const BufferNeeds& needs) {
  const std::uint64_t picture = bytes(kPictureFormat, needs.picture_size_px) + plane_bytes(needs);
  if (!needs.casts_rays) return picture;
  return picture + ray_bytes(needs) + branch_bytes(needs) + light_bytes(needs) +
         bytes_for(needs.work, needs.picture_size_px);
}

int longest_side_px(const BufferNeeds& needs) {
  const glm::ivec2 rays_px =
      needs.casts_rays ? needs.picture_size_px * needs.supersampling : needs.picture_size_px;
  const glm::ivec2 longest = glm::max(rays_px, needs.picture_size_px + needs.work.beyond_px);
  return std::max(longest.x, longest.y) + 1;  // luma of an odd side is padded
}

}  // namespace cutaway
