#include "import/pictures/orientation.h"

#include <algorithm>
#include <vector>

namespace cutaway::reading {

Orientation tiff_orientation(int value) {
  const auto is_one_of = [&](auto... values) { return ((value == values) || ...); };
  return {is_one_of(5, 6, 7, 8), is_one_of(2, 3, 6, 7), is_one_of(3, 4, 7, 8)};
}

void turn(const Orientation& orientation, const PixelLayout& seen, std::span<std::byte> pixels) {
  if (orientation.is_usual()) return;
  const std::vector<std::byte> stored(pixels.begin(), pixels.end());
  const std::size_t bytes = component_bytes(seen.component) * seen.channels;
  const glm::ivec2 last = seen.size_px - 1;
  const int stored_width = orientation.transposed ? seen.size_px.y : seen.size_px.x;
  std::byte* to = pixels.data();
  for (int y = 0; y <= last.y; ++y) {
    for (int x = 0; x <= last.x; ++x, to += bytes) {
      const int across = orientation.from_right ? last.x - x : x;
      const int down = orientation.from_bottom ? last.y - y : y;
      const int row = orientation.transposed ? across : down;
      const int column = orientation.transposed ? down : across;
      const std::byte* from = stored.data() + (std::size_t(row) * stored_width + column) * bytes;
      std::copy_n(from, bytes, to);
    }
  }
}

}  // namespace cutaway::reading
