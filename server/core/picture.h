// A picture before it is compressed, and after.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/pixel_plane.h"

namespace cutaway {

/// yuv420 and yuv444: planes Y, Cb, Cr of full-range YCbCr (ITU-T T.871), a byte a pixel. Chroma of
/// 420 is half the picture's size, rounded up, and its luma twice that: odd sides are padded by
/// repeating the last column and row. rgba: one plane of display-encoded sRGB, 4 bytes a pixel.
enum class PixelLayout { yuv420, yuv444, rgba };

struct PlaneShape {
  glm::ivec2 size_px;
  int bytes_per_pixel;
};

/// In their order.
std::vector<PlaneShape> plane_shapes(PixelLayout layout, glm::ivec2 size_px);

/// Its planes are always those of its layout and size; what was moved from has neither pixels nor
/// planes, as one that was made without a size. Throws as PixelPlane does.
class Picture {
 public:
  Picture() = default;
  /// All bytes zero.
  Picture(PixelLayout layout, glm::ivec2 size_px);
  /// `planes` are those of plane_shapes.
  Picture(PixelLayout layout, glm::ivec2 size_px, std::vector<PixelPlane> planes);
  Picture(const Picture&) = default;
  Picture& operator=(const Picture&) = default;
  Picture(Picture&& other) noexcept { *this = std::move(other); }
  Picture& operator=(Picture&& other) noexcept;
  ~Picture() = default;

  PixelLayout layout() const { return layout_; }
  glm::ivec2 size_px() const { return size_px_; }
  std::span<const PixelPlane> planes() const { return planes_; }
  const PixelPlane& plane(std::size_t index) const { return planes_.at(index); }
  std::size_t bytes() const;

  /// Copies `part` of another picture of the same layout to `at`. Under 4:2:0 both begin on even
  /// pixels, and a part that ends on an odd one ends at both pictures' borders.
  void copy(const Picture& from, const PixelRect& part, glm::ivec2 at);

  bool operator==(const Picture&) const = default;

 private:
  PixelLayout layout_ = PixelLayout::rgba;
  glm::ivec2 size_px_{0};
  std::vector<PixelPlane> planes_;
};

/// A whole file, and the size that it says in its header.
struct JpegPicture {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> bytes;
};

/// The same; a type of its own, so that neither can be sent for the other.
struct PngPicture {
  glm::ivec2 size_px{0};
  std::vector<std::uint8_t> bytes;
};

}  // namespace cutaway
