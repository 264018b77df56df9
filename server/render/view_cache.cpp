#include "render/view_cache.h"

#include <algorithm>
#include <numeric>

#include "core/check.h"

namespace cutaway {

ViewState& ViewCache::pin(std::uint64_t view) {
  Entry& entry = views_[view];
  check(!entry.pinned, "a view is drawn by one plan at a time");
  entry.pinned = true;
  entry.dropped = false;
  entry.used = Clock::now();
  return entry.state;
}

void ViewCache::unpin(std::uint64_t view) {
  const auto entry = views_.find(view);
  check(entry != views_.end() && entry->second.pinned, "a view was pinned before");
  entry->second.pinned = false;
  if (entry->second.dropped) views_.erase(entry);
}

void ViewCache::drop(std::uint64_t view) {
  const auto entry = views_.find(view);
  if (entry == views_.end()) return;
  entry->second.dropped = true;
  if (!entry->second.pinned) views_.erase(entry);
}

void ViewCache::keep_within_limit() {
  while (used_bytes() > bytes_) {
    auto oldest = views_.end();
    for (auto entry = views_.begin(); entry != views_.end(); ++entry) {
      if (entry->second.pinned) continue;
      if (oldest == views_.end() || entry->second.used < oldest->second.used) oldest = entry;
    }
    if (oldest == views_.end()) return;
    views_.erase(oldest);
  }
}

void ViewCache::drop_idle(Clock::duration age) {
  const auto before = Clock::now() - age;
  std::erase_if(views_,
                [&](const auto& view) { return !view.second.pinned && view.second.used < before; });
}

// The other half is for the one that comes, which may be larger than any so far.
bool ViewCache::has_room() const {
  std::uint64_t pinned = 0;
  for (const auto& [view, entry] : views_) pinned += entry.pinned ? entry.state.bytes() : 0;
  return pinned <= bytes_ / 2;
}

std::uint64_t ViewCache::used_bytes() const {
  return std::accumulate(
      views_.begin(), views_.end(), std::uint64_t{0},
      [](std::uint64_t sum, const auto& view) { return sum + view.second.state.bytes(); });
}

}  // namespace cutaway
