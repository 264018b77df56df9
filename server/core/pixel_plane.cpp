#include "core/pixel_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace cutaway {

namespace {

void require(bool holds, const std::string& what) {
  if (!holds) throw std::out_of_range(what);
}

bool is_within(const PixelRect& part, glm::ivec2 size_px) {
  return glm::all(glm::greaterThanEqual(part.begin, glm::ivec2(0))) &&
         glm::all(glm::lessThanEqual(part.begin, part.end)) &&
         glm::all(glm::lessThanEqual(part.end, size_px));
}

void require_within(const PixelRect& part, glm::ivec2 size_px, const char* of_what) {
  require(is_within(part, size_px),
          fmt::format("pixels {},{} to {},{} are not of a {} of {} x {}", part.begin.x,
                      part.begin.y, part.end.x, part.end.y, of_what, size_px.x, size_px.y));
}

}  // namespace

std::size_t packed_bytes(glm::ivec2 size_px, int bytes_per_pixel) {
  require(size_px.x >= 0 && size_px.y >= 0 && bytes_per_pixel > 0,
          fmt::format("there are no {} x {} pixels of {} bytes", size_px.x, size_px.y,
                      bytes_per_pixel));
  return std::size_t(size_px.x) * std::size_t(size_px.y) * std::size_t(bytes_per_pixel);
}

PixelPlane::PixelPlane(glm::ivec2 size_px, int bytes_per_pixel)
    : size_px_(size_px),
      bytes_per_pixel_(bytes_per_pixel),
      bytes_(packed_bytes(size_px, bytes_per_pixel)) {}

PixelPlane::PixelPlane(glm::ivec2 size_px, int bytes_per_pixel,
                       std::span<const std::uint8_t> packed)
    : size_px_(size_px), bytes_per_pixel_(bytes_per_pixel) {
  require(packed.size() == packed_bytes(size_px, bytes_per_pixel),
          fmt::format("{} bytes are not {} x {} pixels of {}", packed.size(), size_px.x, size_px.y,
                      bytes_per_pixel));
  bytes_.assign(packed.begin(), packed.end());
}

PixelPlane& PixelPlane::operator=(PixelPlane&& other) noexcept {
  size_px_ = std::exchange(other.size_px_, glm::ivec2(0));
  bytes_per_pixel_ = other.bytes_per_pixel_;
  bytes_ = std::exchange(other.bytes_, {});
  return *this;
}

std::span<const std::uint8_t> PixelPlane::row(int y) const {
  require_within({{0, y}, {size_px_.x, y + 1}}, size_px_, "plane");
  return std::span(bytes_).subspan(stride_bytes() * std::size_t(y), stride_bytes());
}

std::span<std::uint8_t> PixelPlane::row(int y) {
  require_within({{0, y}, {size_px_.x, y + 1}}, size_px_, "plane");
  return std::span(bytes_).subspan(stride_bytes() * std::size_t(y), stride_bytes());
}

void PixelPlane::copy(const PixelPlane& from, const PixelRect& part, glm::ivec2 at) {
  require(bytes_per_pixel_ == from.bytes_per_pixel_,
          fmt::format("a plane of {} bytes a pixel takes none of {}", bytes_per_pixel_,
                      from.bytes_per_pixel_));
  require_within(part, from.size_px_, "plane");
  require_within({at, at + part.size_px()}, size_px_, "plane");
  const auto bytes_of = [this](int pixels) { return std::size_t(pixels) * bytes_per_pixel_; };
  for (int y = 0; y < part.size_px().y; ++y) {
    const auto source =
        from.row(part.begin.y + y).subspan(bytes_of(part.begin.x), bytes_of(part.size_px().x));
    std::ranges::copy(source, row(at.y + y).subspan(bytes_of(at.x)).begin());
  }
}

}  // namespace cutaway
