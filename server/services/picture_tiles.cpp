#include "services/picture_tiles.h"

#include <algorithm>
#include <utility>

#include "render/stage_keys.h"

namespace cutaway {

namespace {

/// Pictures up to this side are drawn at once; tiles have at most half of it.
constexpr int kLargestSide_px = 2048;
constexpr int kTileSide_px = kLargestSide_px / 2;
constexpr std::size_t kBytesAPixel = 4;

int tiles_along(int side_px) { return (side_px + kTileSide_px - 1) / kTileSide_px; }

}  // namespace

bool PictureTiles::is_due(glm::ivec2 size_px) {
  return std::max(size_px.x, size_px.y) > kLargestSide_px;
}

PictureTiles::PictureTiles(const RenderRequest& whole)
    : whole_(whole),
      size_px_(whole.settings.picture_size_px),
      margin_px_(tile_margin_px(*whole.scene)),
      columns_(tiles_along(size_px_.x)),
      rows_(tiles_along(size_px_.y)),
      rgba_(kBytesAPixel * static_cast<std::size_t>(size_px_.x) * size_px_.y) {}

PictureTiles::Part PictureTiles::part(int index) const {
  const glm::ivec2 begin = glm::ivec2(index % columns_, index / columns_) * kTileSide_px;
  const glm::ivec2 end = glm::min(begin + kTileSide_px, size_px_);
  return {begin, end, glm::max(begin - margin_px_, glm::ivec2(0)),
          glm::min(end + margin_px_, size_px_)};
}

RenderRequest PictureTiles::request(int index) const {
  const Part drawn = part(index);
  RenderRequest request = whole_;
  request.settings.picture_size_px = drawn.drawn_end_px - drawn.drawn_begin_px;
  request.settings.tile = PictureTile{drawn.drawn_begin_px, size_px_};
  return request;
}

void PictureTiles::take(int index, const Pixels& tile) {
  const Part taken = part(index);
  const glm::ivec2 inset = taken.begin_px - taken.drawn_begin_px;
  const std::size_t row_bytes = kBytesAPixel * (taken.end_px.x - taken.begin_px.x);
  for (int y = taken.begin_px.y; y < taken.end_px.y; ++y) {
    const std::size_t row = y - taken.drawn_begin_px.y;
    const auto from = tile.planes.at(0).begin() + kBytesAPixel * (row * tile.size_px.x + inset.x);
    const auto to = rgba_.begin() + kBytesAPixel * (std::size_t(y) * size_px_.x + taken.begin_px.x);
    std::copy_n(from, row_bytes, to);
  }
}

Pixels PictureTiles::picture() {
  Pixels pixels{PixelLayout::rgba, size_px_, {}};
  pixels.planes.push_back(std::move(rgba_));
  return pixels;
}

}  // namespace cutaway
