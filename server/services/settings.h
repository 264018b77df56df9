// Every limit of volumes and renderer; the configuration fills it (app/config.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/render_limits.h"

namespace cutaway {

struct VolumeSettings {
  std::vector<std::filesystem::path> data;  ///< folders or files whose volumes are offered
  std::uint64_t volume_bytes = std::uint64_t{4} << 30;  ///< decoded voxels of one volume
  std::uint64_t memory_bytes = 0;  ///< all loaded volumes together; 0: half of the machine's memory
  int load_threads = 2;
  /// The program whose `read-volume-worker` reads files in a process of its own; empty: no separate
  /// process. Not in the configuration file: the server names itself.
  std::filesystem::path reader;
  bool operator==(const VolumeSettings&) const = default;
};

struct RendererSettings {
  bool require_gpu = false;
  int encode_threads = 2;
  RenderLimits limits;
  bool operator==(const RendererSettings&) const = default;
};

}  // namespace cutaway
