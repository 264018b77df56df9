// Pixels as a value that knows its size, so that no length has to be computed beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/pixel_rect.h"

namespace cutaway {

/// Rows top first. What does not fit throws std::out_of_range, in every build: it ends the picture
/// at hand, and nothing is read or written beside one. What was moved from has no pixels.
class PixelPlane {
 public:
  PixelPlane() = default;
  /// All bytes zero. No side is negative.
  PixelPlane(glm::ivec2 size_px, int bytes_per_pixel);
  /// Of tightly packed rows: exactly as many bytes as the pixels take.
  PixelPlane(glm::ivec2 size_px, int bytes_per_pixel, std::span<const std::uint8_t> packed);
  PixelPlane(const PixelPlane&) = default;
  PixelPlane& operator=(const PixelPlane&) = default;
  PixelPlane(PixelPlane&& other) noexcept { *this = std::move(other); }
  PixelPlane& operator=(PixelPlane&& other) noexcept;
  ~PixelPlane() = default;

  glm::ivec2 size_px() const { return size_px_; }
  int bytes_per_pixel() const { return bytes_per_pixel_; }
  /// From one row to the next.
  std::size_t stride_bytes() const { return std::size_t(size_px_.x) * bytes_per_pixel_; }
  std::span<const std::uint8_t> bytes() const { return bytes_; }
  std::span<const std::uint8_t> row(int y) const;
  std::span<std::uint8_t> row(int y);

  /// Copies `part` of another plane to where its first pixel comes to lie at `at`. Both have as
  /// many bytes a pixel; the part lies in the other plane, and in this one where it is put.
  void copy(const PixelPlane& from, const PixelRect& part, glm::ivec2 at);

  bool operator==(const PixelPlane&) const = default;

 private:
  glm::ivec2 size_px_{0};
  int bytes_per_pixel_ = 1;
  std::vector<std::uint8_t> bytes_;
};

/// How many bytes so many pixels take; throws as PixelPlane does.
std::size_t packed_bytes(glm::ivec2 size_px, int bytes_per_pixel);

}  // namespace cutaway
