// Lines along gaps in depth: every pixel that begins one is tried for every pixel beside it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "support/reference_filters.h"

namespace cutaway::reference {

namespace {

constexpr double kEndless = 1e9;

bool is_met(const BranchImage& input, glm::ivec2 at) {
  return input.contains(at) && input.at(at).coverage > 0.0;
}

/// `across_rim`: where the lens' rim lies between.
double fall(const BranchImage& input, glm::ivec2 here, glm::ivec2 there, double across_rim) {
  if (!is_met(input, here) || !is_met(input, there)) return 0.0;
  const BranchPixel& from = input.at(here);
  const BranchPixel& to = input.at(there);
  if (std::abs(from.behind_lens - to.behind_lens) > 0.2) return across_rim;
  return to.nearest_mm - from.nearest_mm;
}

/// Of the steps from pixel to pixel before or behind a gap, in the direction of the gap.
double steepest(const BranchImage& input, glm::ivec2 from, glm::ivec2 way, int count, bool behind) {
  double most = 0.0;
  for (int i = 0; i < count; ++i) {
    const double across_rim = i == 0 ? kEndless : 0.0;
    const glm::ivec2 one = from + i * way;
    const glm::ivec2 other = from + (i + 1) * way;
    most = std::max(
        most, behind ? fall(input, one, other, across_rim) : fall(input, other, one, across_rim));
  }
  return most;
}

double gap(const BranchImage& input, glm::ivec2 at, glm::ivec2 way, const DepthLines& lines) {
  const glm::ivec2 next = at + way;
  if (input.contains(next) && !is_met(input, next))
    return lines.silhouettes && input.at(next).silhouette_coverage == 0.0 ? kEndless : 0.0;
  const int flight_px = static_cast<int>(std::ceil(2.0 * lines.width_px));
  return fall(input, at, next, 0.0) - steepest(input, at, -way, flight_px, false) -
         steepest(input, next, way, flight_px, true);
}

struct Begin {
  double width_px = 0.0;
  double behind_mm = 0.0;
};

std::optional<Begin> begin_at(const BranchImage& input, glm::ivec2 at, const DepthLines& lines) {
  if (!is_met(input, at)) return std::nullopt;
  double widest = -kEndless;
  for (const glm::ivec2 way : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
    widest = std::max(widest, gap(input, at, way, lines));
  if (widest <= lines.gap_mm) return std::nullopt;
  const double grown = std::clamp(
      (widest - lines.gap_mm) / std::max(lines.full_gap_mm - lines.gap_mm, 1e-3), 0.0, 1.0);
  const double faded = std::min((widest - lines.gap_mm) / (0.5 * lines.gap_mm), 1.0);
  const double width_px = lines.width_px * faded * std::lerp(lines.thinnest, 1.0, grown);
  if (width_px <= 0.0) return std::nullopt;
  return Begin{width_px + 1.0 - input.at(at).coverage,
               input.at(at).nearest_mm + 0.5 * std::min(widest, lines.full_gap_mm)};
}

using Begins = Image<std::optional<Begin>>;

/// Without those that have not a neighbour on each of two sides.
Begins without_specks(const Begins& begins) {
  Begins kept = begins;
  for (int y = 0; y < begins.size_px.y; ++y) {
    for (int x = 0; x < begins.size_px.x; ++x) {
      int others = begins.at({x, y}) ? -1 : 0;
      for (int i = 0; i < 9; ++i) {
        const glm::ivec2 there(x + i % 3 - 1, y + i / 3 - 1);
        others += begins.contains(there) && begins.at(there) ? 1 : 0;
      }
      if (others < 2) kept.at({x, y}).reset();
    }
  }
  return kept;
}

/// How much of the pixel the line covers that reaches farthest beyond it.
double coverage(const BranchImage& input, const Begins& begins, glm::ivec2 at, int reach_px) {
  double farthest = 0.0;
  double covered = 0.0;
  for (int y = -reach_px; y <= reach_px; ++y) {
    for (int x = -reach_px; x <= reach_px; ++x) {
      const glm::ivec2 from = at + glm::ivec2(x, y);
      if (!begins.contains(from) || !begins.at(from)) continue;
      const Begin& begin = *begins.at(from);
      const double beyond = begin.width_px * begin.width_px - x * x - y * y;
      if (beyond <= farthest) continue;
      farthest = beyond;
      covered = input.at(at).nearest_mm < begin.behind_mm
                    ? std::clamp(begin.width_px - std::hypot(x, y), 0.0, 1.0)
                    : 0.0;
    }
  }
  return covered;
}

}  // namespace

BranchImage depth_lines(const BranchImage& input, const DepthLines& lines) {
  Begins begins(input.size_px);
  BranchImage output = input;
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x) begins.at({x, y}) = begin_at(input, {x, y}, lines);
  }
  begins = without_specks(begins);
  const int reach_px = static_cast<int>(std::ceil(lines.width_px)) + 1;
  for (int y = 0; y < input.size_px.y; ++y) {
    for (int x = 0; x < input.size_px.x; ++x) {
      BranchPixel& pixel = output.at({x, y});
      if (pixel.coverage == 0.0) continue;
      pixel.colour = glm::mix(pixel.colour, lines.ink,
                              lines.strength * coverage(input, begins, {x, y}, reach_px));
    }
  }
  return output;
}

}  // namespace cutaway::reference
