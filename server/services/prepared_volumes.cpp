#include "services/prepared_volumes.h"

#include <algorithm>
#include <utility>

namespace cutaway {

namespace {

constexpr std::size_t kKept = 2;

VolumePreparation without_islands(VolumePreparation preparation) {
  preparation.islands = {};
  return preparation;
}

}  // namespace

PreparedVolumes::Shared PreparedVolumes::find(const VolumePreparation& preparation) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(kept_, preparation, &Entry::preparation);
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().volume;
}

PreparedVolumes::Shared PreparedVolumes::nearest(const VolumePreparation& preparation) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find_if(kept_, [&](const Entry& entry) {
    return without_islands(entry.preparation) == without_islands(preparation);
  });
  return found == kept_.end() ? nullptr : found->volume;
}

void PreparedVolumes::put(const VolumePreparation& preparation, Shared volume) {
  const std::lock_guard lock(mutex_);
  kept_.push_front({preparation, std::move(volume)});
  if (kept_.size() > kKept) kept_.pop_back();
}

std::uint64_t PreparedVolumes::bytes() const {
  const std::lock_guard lock(mutex_);
  std::uint64_t sum = 0;
  for (const Entry& entry : kept_) sum += memory_bytes(*entry.volume);
  return sum;
}

}  // namespace cutaway
