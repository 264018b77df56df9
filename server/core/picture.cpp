#include "core/picture.h"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>
#include <utility>

namespace cutaway {

namespace {

constexpr int kRgbaBytes = 4;

/// Sides of the pixels of a layout's smallest plane, in pixels of the picture.
int block_px(PixelLayout layout) { return layout == PixelLayout::yuv420 ? 2 : 1; }

/// Whether whole blocks lie between those two, or it ends with the picture.
bool is_whole_blocks(const PixelRect& part, int block, glm::ivec2 size_px) {
  const auto ends_well = [&](int end, int size) { return end % block == 0 || end == size; };
  return part.begin % block == glm::ivec2(0) && ends_well(part.end.x, size_px.x) &&
         ends_well(part.end.y, size_px.y);
}

void require_whole_blocks(const PixelRect& part, int block, glm::ivec2 size_px) {
  if (is_whole_blocks(part, block, size_px)) return;
  throw std::out_of_range(
      fmt::format("pixels {},{} to {},{} of {} x {} cut a {} x {} block of chroma", part.begin.x,
                  part.begin.y, part.end.x, part.end.y, size_px.x, size_px.y, block, block));
}

PixelRect blocks_of(const PixelRect& part, int block) {
  return {part.begin / block, (part.end + block - 1) / block};
}

PixelRect scaled(const PixelRect& part, int factor) {
  return {part.begin * factor, part.end * factor};
}

}  // namespace

std::vector<PlaneShape> plane_shapes(PixelLayout layout, glm::ivec2 size_px) {
  if (layout == PixelLayout::rgba) return {{size_px, kRgbaBytes}};
  const int block = block_px(layout);
  const glm::ivec2 chroma_px = (size_px + block - 1) / block;
  return {{chroma_px * block, 1}, {chroma_px, 1}, {chroma_px, 1}};
}

Picture::Picture(PixelLayout layout, glm::ivec2 size_px) : layout_(layout), size_px_(size_px) {
  for (const PlaneShape& shape : plane_shapes(layout, size_px))
    planes_.emplace_back(shape.size_px, shape.bytes_per_pixel);
}

Picture::Picture(PixelLayout layout, glm::ivec2 size_px, std::vector<PixelPlane> planes)
    : layout_(layout), size_px_(size_px), planes_(std::move(planes)) {
  const std::vector<PlaneShape> shapes = plane_shapes(layout, size_px);
  bool fits = planes_.size() == shapes.size();
  for (std::size_t i = 0; fits && i < shapes.size(); ++i)
    fits = planes_[i].size_px() == shapes[i].size_px &&
           planes_[i].bytes_per_pixel() == shapes[i].bytes_per_pixel;
  if (!fits)
    throw std::out_of_range(
        fmt::format("these are not the planes of {} x {} pixels", size_px.x, size_px.y));
}

Picture& Picture::operator=(Picture&& other) noexcept {
  layout_ = other.layout_;
  size_px_ = std::exchange(other.size_px_, glm::ivec2(0));
  planes_ = std::exchange(other.planes_, {});
  return *this;
}

std::size_t Picture::bytes() const {
  return std::accumulate(
      planes_.begin(), planes_.end(), std::size_t{0},
      [](std::size_t sum, const PixelPlane& plane) { return sum + plane.bytes().size(); });
}

void Picture::copy(const Picture& from, const PixelRect& part, glm::ivec2 at) {
  if (layout_ != from.layout_) throw std::out_of_range("a picture takes none of another layout");
  const PixelRect taken{at, at + part.size_px()};
  const int block = block_px(layout_);
  require_whole_blocks(part, block, from.size_px_);
  require_whole_blocks(taken, block, size_px_);
  const PixelRect chroma = blocks_of(part, block);
  const glm::ivec2 chroma_at = at / block;
  planes_.at(0).copy(from.plane(0), scaled(chroma, block), chroma_at * block);
  for (std::size_t i = 1; i < planes_.size(); ++i)
    planes_[i].copy(from.plane(i), chroma, chroma_at);
}

}  // namespace cutaway
