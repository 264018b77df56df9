// A loaded volume as scenes have it prepared.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>

#include "volume/prepared/preparation.h"

namespace cutaway {

/// Thread-safe. The two that were made or asked for last are kept.
class PreparedVolumes {
 public:
  using Shared = std::shared_ptr<const LoadedVolume>;

  /// Null where it has not been made.
  Shared find(const VolumePreparation& preparation);
  /// The newest that differs in islands alone: what is seen until the right one is made.
  Shared nearest(const VolumePreparation& preparation) const;
  void put(const VolumePreparation& preparation, Shared volume);
  std::uint64_t bytes() const;

 private:
  struct Entry {
    VolumePreparation preparation;
    Shared volume;
  };

  mutable std::mutex mutex_;
  std::list<Entry> kept_;  ///< the newest first
};

}  // namespace cutaway
