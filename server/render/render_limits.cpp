#include "render/render_limits.h"

#include <algorithm>

namespace cutaway {

namespace {

constexpr std::uint64_t kVolumeBytes = std::uint64_t{8} << 30;
constexpr std::uint64_t kViewBytes = std::uint64_t{2} << 30;
/// About 20 ms on two cores.
constexpr std::int64_t kStepInSoftware = std::int64_t{1} << 19;
/// On a GPU any frame is drawn as a whole.
constexpr std::int64_t kStep = std::int64_t{1} << 27;

template <typename T>
void fill_in(T& place, T value) {
  if (place == 0) place = value;
}

}  // namespace

RenderLimits limits_for(const RenderLimits& wanted, bool is_software, std::uint64_t machine_bytes) {
  RenderLimits limits = wanted;
  fill_in(limits.volume_bytes, is_software ? machine_bytes / 4 : kVolumeBytes);
  fill_in(limits.view_bytes, is_software ? std::min(machine_bytes / 8, kViewBytes) : kViewBytes);
  fill_in(limits.step, is_software ? kStepInSoftware : kStep);
  return limits;
}

}  // namespace cutaway
