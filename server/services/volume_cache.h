// Loaded volumes, kept as long as someone shows them and beyond that while there is room.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>

#include "services/opened_volume.h"

namespace cutaway {

/// Not thread-safe. Of what nobody shows any more the least recently used goes first.
class VolumeCache {
 public:
  explicit VolumeCache(std::uint64_t bytes) : bytes_(bytes) {}

  /// Null where it is not loaded.
  std::shared_ptr<const OpenedVolume> find(const std::string& id);
  /// Drops what nobody shows until so many more bytes fit. Throws Error where they cannot.
  void make_room(std::uint64_t bytes);
  void add(std::shared_ptr<const OpenedVolume> volume);

  std::uint64_t used_bytes() const;

 private:
  std::uint64_t bytes_;
  std::list<std::shared_ptr<const OpenedVolume>> volumes_;  ///< the most recently used first
};

}  // namespace cutaway
