// Small pictures of whole volumes, kept for all sessions: a listing shows the same to everyone.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "session/frame_source.h"

namespace cutaway {

/// Thread-safe. At most kMostPictures. The pictures that were not asked for for longest go first.
class PreviewCache {
 public:
  explicit PreviewCache(std::size_t bytes = std::size_t{16} << 20) : bytes_(bytes) {}

  /// Null where there is none.
  std::shared_ptr<const Frame> find(const std::string& key);
  void put(const std::string& key, std::shared_ptr<const Frame> frame);

 private:
  static constexpr std::size_t kMostPictures = 512;
  using Entry = std::pair<std::string, std::shared_ptr<const Frame>>;

  std::size_t bytes_;
  std::mutex mutex_;
  std::list<Entry> entries_;  ///< newest first
  std::size_t used_bytes_ = 0;
};

}  // namespace cutaway
