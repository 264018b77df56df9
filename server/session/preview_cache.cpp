#include "session/preview_cache.h"

#include <algorithm>

namespace cutaway {

std::shared_ptr<const Frame> PreviewCache::find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto entry = std::ranges::find(entries_, key, &Entry::first);
  if (entry == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, entry);
  return entry->second;
}

void PreviewCache::put(const std::string& key, std::shared_ptr<const Frame> frame) {
  const std::lock_guard lock(mutex_);
  if (std::ranges::find(entries_, key, &Entry::first) != entries_.end()) return;
  used_bytes_ += frame->picture.bytes.size();
  entries_.emplace_front(key, std::move(frame));
  while (used_bytes_ > bytes_ || entries_.size() > kMostPictures) {
    used_bytes_ -= entries_.back().second->picture.bytes.size();
    entries_.pop_back();
  }
}

}  // namespace cutaway
