// A volume that is to be put on the device.
#pragma once

#include <future>
#include <memory>
#include <stop_token>

#include "core/progress.h"
#include "volume/loaded_volume.h"

namespace cutaway {

struct UploadJob {
  std::shared_ptr<const LoadedVolume> volume;
  ProgressSink progress;
  std::stop_token stop;
  std::promise<void> done;
};

}  // namespace cutaway
