// The volumes on the device: each once for all views, within a limit.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>

#include "render/gpu_volume.h"

namespace cutaway {

/// Render thread only. What nobody holds any more goes; where the rest is more than the limit, so
/// do the least recently used, those that no view shows before the others. One that is used again
/// is put on the device again.
class DeviceVolumes {
 public:
  DeviceVolumes(int max_texture_size, std::uint64_t bytes)
      : max_texture_size_(max_texture_size), bytes_(bytes) {}

  /// The volume, with room for it made where it is not there yet; complete or not. Whoever goes on
  /// using it holds it: beyond the limit, if need be. Throws Error "volume-refused" or "too-large"
  /// when the device could not hold it alone.
  std::shared_ptr<GpuVolume> use(const std::shared_ptr<const LoadedVolume>& loaded);
  /// From now on the view shows this volume, also while it rests, until it is forgotten.
  void show(std::uint64_t view, const std::shared_ptr<const LoadedVolume>& loaded) {
    shown_[view] = {loaded};
  }
  void forget(std::uint64_t view) { shown_.erase(view); }
  void drop(const std::shared_ptr<const LoadedVolume>& loaded);
  void drop_unwanted();

  std::uint64_t used_bytes() const;

 private:
  std::shared_ptr<GpuVolume> place(const std::shared_ptr<const LoadedVolume>& loaded);
  bool drop_oldest();
  bool is_shown(const GpuVolume& volume) const;

  int max_texture_size_;
  std::uint64_t bytes_;
  std::list<std::shared_ptr<GpuVolume>> volumes_;  ///< the most recently used first
  std::map<std::uint64_t, VolumeIdentity> shown_;  ///< by view
};

}  // namespace cutaway
