// A picture whose buffers would be too large is drawn in parts, one after the other, and put
// together from them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/render_settings.h"
#include "scene/scene.h"

namespace cutaway {

/// What the buffers of one part may be.
struct PartLimits {
  std::uint64_t bytes = 0;
  int side_px = 0;  ///< of a texture
};

/// Parts overlap by what filters read beside a pixel. Their place follows from scene, settings and
/// limits alone, so that the same picture is always drawn the same way.
class PictureParts {
 public:
  PictureParts() = default;
  /// Of the whole picture: one part where that is within the limits. Does not keep the scene.
  PictureParts(const Scene& scene, const RenderSettings& whole, const PartLimits& limits);

  std::size_t count() const { return parts_.size(); }
  /// Of a part's picture.
  RenderSettings settings(std::size_t index) const;

  /// Takes a part's share of the picture; each once, in any order.
  void take(std::size_t index, Picture drawn);
  bool is_whole() const { return taken_ == parts_.size(); }
  /// Once it is whole.
  Picture whole();

 private:
  struct Part {
    PixelRect taken;  ///< what the whole picture takes of it
    PixelRect drawn;
  };

  RenderSettings whole_;
  std::vector<Part> parts_;
  std::size_t taken_ = 0;
  Picture picture_;
};

}  // namespace cutaway
