#include "import/dicom/window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cutaway::reading {

namespace {

constexpr std::size_t kMostLookedAt = std::size_t{1} << 20;
constexpr double kFewestInside = 0.01;  // of the values that are no background

/// Of the values that are not the darkest one, which is often no more than background.
template <typename T>
double share_inside(const std::vector<T>& values, double slope, double intercept,
                    const ValueRange& window) {
  const std::size_t step = std::max<std::size_t>(values.size() / kMostLookedAt, 1);
  const auto physical = [&](std::size_t i) {
    return static_cast<double>(values[i]) * slope + intercept;
  };
  double darkest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < values.size(); i += step)
    if (std::isfinite(physical(i))) darkest = std::min(darkest, physical(i));
  std::size_t all = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < values.size(); i += step) {
    const double value = physical(i);
    if (!(value > darkest)) continue;
    ++all;
    if (value >= window.minimum && value <= window.maximum) ++inside;
  }
  return all == 0 ? 1.0 : static_cast<double>(inside) / static_cast<double>(all);
}

}  // namespace

std::optional<ValueRange> window_of_middle(const DicomGroup& group) {
  const auto& frames = group.frames;
  for (std::size_t distance = 0; distance <= frames.size(); ++distance) {
    const std::size_t above = frames.size() / 2 + distance;
    if (above < frames.size() && frames[above].window) return frames[above].window;
    if (distance > frames.size() / 2) continue;
    const std::size_t below = frames.size() / 2 - distance;
    if (frames[below].window) return frames[below].window;
  }
  return std::nullopt;
}

void leave_out_useless_window(RawVolume& raw) {
  const auto window = raw.description.window;
  if (!window) return;
  const double inside = std::visit(
      [&](const auto& values) { return share_inside(values, raw.slope, raw.intercept, *window); },
      raw.voxels);
  if (inside >= kFewestInside) return;
  raw.description.window.reset();
  raw.description.warnings.push_back(
      fmt::format("the file's window, {:.4g} to {:.4g}, shows nothing of its values; left out",
                  window->minimum, window->maximum));
}

}  // namespace cutaway::reading
