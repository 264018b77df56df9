// The renderer as far as loading a volume goes.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>

#include "core/progress.h"
#include "volume/loaded_volume.h"

namespace cutaway {

struct UploadTarget {
  int largest_edge_voxels = 0;  ///< of a volume that the renderer can hold
  /// Returns once the volume can be drawn. Throws Error, or Cancelled when stopped. Thread-safe.
  std::function<void(const std::shared_ptr<const LoadedVolume>&, const ProgressSink&,
                     const std::stop_token&)>
      upload;
};

}  // namespace cutaway
