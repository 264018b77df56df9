// A volume that the command line names: a phantom, or a file or folder.
#pragma once

#include <memory>
#include <string>

#include "core/progress.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// Reads "phantom:NAME[@SIZE]" or the volume at a path. A path that holds several wants one of
/// their ids after '#': "folder#id". Throws Error saying which there are. Blocks until it is
/// loaded.
std::shared_ptr<const LoadedVolume> load_volume_argument(const std::string& argument,
                                                         const ProgressSink& progress);

}  // namespace cutaway
