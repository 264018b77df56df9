// Everything that can be set, with its default; deploy/cutaway.toml says it for people. A file
// (TOML) and then the command line change it.
#pragma once

#include <filesystem>
#include <string>

#include "net/settings.h"
#include "services/settings.h"
#include "session/settings.h"

namespace cutaway {

struct Config {
  NetSettings net;
  SessionSettings session = {.viewport_pixels = 0};  ///< 0: by the renderer
  VolumeSettings volumes;
  RendererSettings renderer;
  bool core_dumps = false;
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
