#include <algorithm>

#include "volume/min_max_grid.h"

namespace cutaway {

namespace {

constexpr int kFarthest = 255;

std::vector<std::uint8_t> mark_bricks(const MinMaxGrid& grid, const ValueBand& band) {
  std::vector<std::uint8_t> distances(grid.minimum.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool holds_some = grid.maximum[i] > band.lower && grid.minimum[i] < band.upper;
    distances[i] = holds_some ? 0 : kFarthest;
  }
  return distances;
}

void sweep_row(std::span<std::uint8_t> row) {
  const auto relax = [](std::uint8_t& here, std::uint8_t neighbour) {
    here = std::uint8_t(std::min<int>(here, neighbour + 1));
  };
  for (std::size_t i = 1; i < row.size(); ++i) relax(row[i], row[i - 1]);
  for (std::size_t i = row.size() - 1; i > 0; --i) relax(row[i - 1], row[i]);
}

/// One axis of the separable transform: with g the distances within lines across this axis, the
/// distance is the minimum over n of max(|n|, g(line + n)). Lines of `length` bytes lie side by
/// side, so each step of the search runs over contiguous memory; it ends once no farther line can
/// be nearer.
class LineSearch {
 public:
  LineSearch(std::span<std::uint8_t> distances, std::size_t length)
      : distances_(distances),
        before_(distances.begin(), distances.end()),
        length_(length),
        lines_(int(distances.size() / length)) {}

  void run() {
    for (int line = 0; line < lines_; ++line) search(line);
  }

 private:
  void search(int line) {
    const std::span<std::uint8_t> best = distances_.subspan(line * length_, length_);
    for (int n = 1; n < std::min<int>(lines_, *std::max_element(best.begin(), best.end())); ++n) {
      if (line - n >= 0) relax(best, line - n, n);
      if (line + n < lines_) relax(best, line + n, n);
    }
  }

  void relax(std::span<std::uint8_t> best, int other, int n) const {
    const std::uint8_t* across = before_.data() + other * length_;
    const auto along = std::uint8_t(n);
    for (std::size_t i = 0; i < length_; ++i) {
      best[i] = std::min(best[i], std::max(across[i], along));
    }
  }

  std::span<std::uint8_t> distances_;
  std::vector<std::uint8_t> before_;
  std::size_t length_;
  int lines_;
};

}  // namespace

std::vector<std::uint8_t> chebyshev_distance_map(const MinMaxGrid& grid, const ValueBand& band) {
  std::vector<std::uint8_t> distances = mark_bricks(grid, band);
  const std::span<std::uint8_t> all(distances);
  const std::size_t row = grid.size_bricks.x;
  const std::size_t plane = row * grid.size_bricks.y;
  for (std::size_t i = 0; i < all.size(); i += row) sweep_row(all.subspan(i, row));
  for (std::size_t i = 0; i < all.size(); i += plane) LineSearch(all.subspan(i, plane), row).run();
  LineSearch(all, plane).run();
  return distances;
}

}  // namespace cutaway
