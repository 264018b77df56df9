#include "render/device_volumes.h"

#include <algorithm>
#include <numeric>

#include "core/error.h"

namespace cutaway {

std::shared_ptr<GpuVolume> DeviceVolumes::use(const std::shared_ptr<const LoadedVolume>& loaded) {
  const auto known = std::ranges::find(volumes_, VolumeIdentity{loaded}, &GpuVolume::identity);
  if (known != volumes_.end()) {
    volumes_.splice(volumes_.begin(), volumes_, known);
    return volumes_.front();
  }
  drop_unwanted();
  while (used_bytes() + GpuVolume::texture_bytes(*loaded) > bytes_ && drop_oldest()) {
  }
  return volumes_.emplace_front(place(loaded));
}

// The limit is what we may take; what the device has left, only trying tells.
std::shared_ptr<GpuVolume> DeviceVolumes::place(const std::shared_ptr<const LoadedVolume>& loaded) {
  while (true) {
    try {
      return std::make_shared<GpuVolume>(loaded, max_texture_size_);
    } catch (const Error& error) {
      if (error.detail().code != ErrorCode::too_large || !drop_oldest()) throw;
    }
  }
}

bool DeviceVolumes::drop_oldest() {
  if (volumes_.empty()) return false;
  const auto unseen = std::find_if(volumes_.rbegin(), volumes_.rend(),
                                   [this](const auto& volume) { return !is_shown(*volume); });
  volumes_.erase(unseen == volumes_.rend() ? std::prev(volumes_.end()) : std::next(unseen).base());
  return true;
}

bool DeviceVolumes::is_shown(const GpuVolume& volume) const {
  return std::ranges::any_of(
      shown_, [identity = volume.identity()](const auto& each) { return each.second == identity; });
}

void DeviceVolumes::drop(const std::shared_ptr<const LoadedVolume>& loaded) {
  const VolumeIdentity identity{loaded};
  std::erase_if(volumes_, [&](const auto& volume) { return volume->identity() == identity; });
}

void DeviceVolumes::drop_unwanted() {
  std::erase_if(volumes_, [](const auto& volume) { return !volume->is_wanted(); });
}

std::uint64_t DeviceVolumes::used_bytes() const {
  return std::accumulate(
      volumes_.begin(), volumes_.end(), std::uint64_t{0},
      [](std::uint64_t sum, const auto& volume) { return sum + volume->texture_bytes(); });
}

}  // namespace cutaway
