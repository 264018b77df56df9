// Everything that can be set, with its default; deploy/cutaway.toml says it for people. A file
// (TOML) and then the command line change it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "net/settings.h"
#include "render/render_thread.h"
#include "session/settings.h"

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

struct Config {
  NetSettings net;
  SessionSettings session;
  VolumeSettings volumes;
  RendererSettings renderer;
  std::string notice = "Not for diagnostic use.";
  std::string log_level = "info";
  bool operator==(const Config&) const = default;
};

/// "ADDRESS:PORT", an IPv6 address in brackets. Throws Error.
void parse_listen(const std::string& text, NetSettings& settings);

/// Changes `config` by the file's content. Relative paths in it are meant from its folder, an empty
/// one is none. Throws Error with FILE:LINE as its field: not TOML, an unknown key, a wrong type, a
/// value out of its range.
void read_config_file(const std::filesystem::path& file, Config& config);

}  // namespace cutaway
