#include "services/volume_cache.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cutaway {

std::shared_ptr<const OpenedVolume> VolumeCache::find(const std::string& id) {
  const auto found = std::ranges::find_if(
      volumes_, [&id](const auto& volume) { return volume->facts().id == id; });
  if (found == volumes_.end()) return nullptr;
  volumes_.splice(volumes_.begin(), volumes_, found);
  return volumes_.front();
}

void VolumeCache::make_room(std::uint64_t bytes) {
  const auto unused = [](const auto& volume) { return volume.use_count() == 1; };
  while (used_bytes() + bytes > bytes_) {
    const auto oldest = std::find_if(volumes_.rbegin(), volumes_.rend(), unused);
    if (oldest == volumes_.rend()) {
      throw Error(
          {.code = ErrorCode::too_large,
           .message = "the memory for volumes has no room for it beside those that are shown",
           .expected = std::to_string(bytes_) + " bytes for all volumes together",
           .received = std::to_string(used_bytes()) + " in use and " + std::to_string(bytes) +
                       " more wanted"});
    }
    volumes_.erase(std::next(oldest).base());
  }
}

void VolumeCache::add(std::shared_ptr<const OpenedVolume> volume) {
  volumes_.push_front(std::move(volume));
}

std::uint64_t VolumeCache::used_bytes() const {
  return std::accumulate(volumes_.begin(), volumes_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& volume) {
                           return sum + memory_bytes(*volume->loaded()) +
                                  volume->prepared().bytes();
                         });
}

}  // namespace cutaway
