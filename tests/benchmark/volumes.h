// The volumes that are measured: the phantoms, and the CTs of a folder.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "volume/loaded_volume.h"

namespace cutaway::benchmark {

struct NamedVolume {
  std::string name;
  std::function<std::shared_ptr<const LoadedVolume>()> load;  ///< reads or computes it now
};

/// Each phantom at each size. Throws Error where the folder is missing, or where this build reads
/// no files.
std::vector<NamedVolume> volumes_to_measure(const std::vector<int>& phantom_sizes_voxels,
                                            const std::optional<std::filesystem::path>& data);

}  // namespace cutaway::benchmark
