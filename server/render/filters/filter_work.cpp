#include "render/filters/filter_work.h"

#include <algorithm>

namespace cutaway {

namespace {

constexpr std::array<GLenum, kWorkFormats> kFormats = {GL_RGBA32F, GL_R32F};

}  // namespace

void WorkNeeds::add(const WorkTexture& texture, glm::ivec2 its_beyond_px) {
  int& textures = count.at(static_cast<std::size_t>(texture.format));
  textures = std::max(textures, texture.number + 1);
  beyond_px = glm::max(beyond_px, its_beyond_px);
}

void WorkNeeds::add(const WorkNeeds& other) {
  for (std::size_t i = 0; i < kWorkFormats; ++i) count[i] = std::max(count[i], other.count[i]);
  beyond_px = glm::max(beyond_px, other.beyond_px);
}

std::uint64_t bytes_for(const WorkNeeds& needs, glm::ivec2 picture_size_px) {
  const glm::ivec2 size_px = picture_size_px + needs.beyond_px;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < kWorkFormats; ++i)
    sum += std::uint64_t(size_px.x) * size_px.y * gl::texel_bytes(kFormats[i]) * needs.count[i];
  return sum;
}

FilterWork::FilterWork(const WorkNeeds& needs, glm::ivec2 picture_size_px) : needs_(needs) {
  for (std::size_t i = 0; i < kWorkFormats; ++i) {
    for (int number = 0; number < needs.count[i]; ++number)
      textures_.emplace(
          WorkTexture{static_cast<WorkFormat>(i), number},
          gl::Texture2D(kFormats[i], picture_size_px + needs.beyond_px, gl::Filtering::nearest));
  }
}

std::uint64_t FilterWork::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& [which, texture] : textures_) sum += texture.bytes();
  return sum;
}

const gl::Texture2D& FilterWork::texture(const WorkTexture& which) const {
  return textures_.at(which);
}

const gl::Framebuffer& FilterWork::target(const std::vector<WorkTexture>& textures) const {
  const auto made = targets_.find(textures);
  if (made != targets_.end()) return made->second;
  std::vector<const gl::Texture2D*> attachments;
  attachments.reserve(textures.size());
  for (const WorkTexture& which : textures) attachments.push_back(&texture(which));
  return targets_.emplace(textures, gl::Framebuffer(attachments)).first->second;
}

}  // namespace cutaway
