// How a large picture is parted into tiles, and put together from them.
#pragma once

#include <cstdint>
#include <vector>

#include "render/render_thread.h"

namespace cutaway {

/// RGBA. Tiles overlap by what filters read beside a pixel.
class PictureTiles {
 public:
  /// Whether a picture of this size is drawn in tiles.
  static bool is_due(glm::ivec2 size_px);

  /// `whole`: the request of the whole picture.
  explicit PictureTiles(const RenderRequest& whole);

  int count() const { return columns_ * rows_; }
  RenderRequest request(int index) const;
  /// Takes the tile's share of the picture; `tile` answers request(index).
  void take(int index, const Pixels& tile);
  /// The whole; once.
  Pixels picture();

 private:
  struct Part {
    glm::ivec2 begin_px;  ///< of what the picture takes from the tile
    glm::ivec2 end_px;
    glm::ivec2 drawn_begin_px;  ///< of what is drawn
    glm::ivec2 drawn_end_px;
  };
  Part part(int index) const;

  const RenderRequest& whole_;
  glm::ivec2 size_px_;
  int margin_px_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> rgba_;
};

}  // namespace cutaway
