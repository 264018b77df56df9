// A part of a picture.
#pragma once

#include <glm/glm.hpp>

namespace cutaway {

/// Pixels [begin, end), row 0 first in memory.
struct PixelRect {
  glm::ivec2 begin{0};
  glm::ivec2 end{0};
  bool is_empty() const { return end.x <= begin.x || end.y <= begin.y; }
  glm::ivec2 size_px() const { return end - begin; }
  bool operator==(const PixelRect&) const = default;
};

}  // namespace cutaway
