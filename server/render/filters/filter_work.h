// What steps of a filter hand from one to the next. Filters run one after the other, so those of a
// view share it; views do not, since their strips are drawn in turn.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace cutaway {

enum class WorkFormat { rgba32f, r32f };
inline constexpr std::size_t kWorkFormats = 2;

/// The texture of that number among those of its format.
struct WorkTexture {
  WorkFormat format = WorkFormat::rgba32f;
  int number = 0;
  auto operator<=>(const WorkTexture&) const = default;
};

/// What one or several filters need at once.
struct WorkNeeds {
  glm::ivec2 beyond_px{0};                ///< how much larger than the picture, right and down
  std::array<int, kWorkFormats> count{};  ///< of textures of each format

  void add(const WorkTexture& texture, glm::ivec2 its_beyond_px);
  void add(const WorkNeeds& other);
  bool is_none() const { return count == std::array<int, kWorkFormats>{}; }
  bool operator==(const WorkNeeds&) const = default;
};

/// What they take on the device.
std::uint64_t bytes_for(const WorkNeeds& needs, glm::ivec2 picture_size_px);

/// Render thread only.
class FilterWork {
 public:
  FilterWork() = default;
  FilterWork(const WorkNeeds& needs, glm::ivec2 picture_size_px);

  const WorkNeeds& needs() const { return needs_; }
  std::uint64_t bytes() const;
  const gl::Texture2D& texture(const WorkTexture& which) const;
  const gl::Framebuffer& target(const std::vector<WorkTexture>& textures) const;

 private:
  WorkNeeds needs_;
  std::map<WorkTexture, gl::Texture2D> textures_;
  mutable std::map<std::vector<WorkTexture>, gl::Framebuffer> targets_;  ///< made when first drawn
};

}  // namespace cutaway
