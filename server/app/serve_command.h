// `cutaway serve`: volumes, a renderer and a listener, put together.
#pragma once

#include <filesystem>

#include "app/config.h"

namespace cutaway {

/// Serves until SIGINT or SIGTERM. Prints "Cutaway is at http://..." on standard output once
/// clients can come. Throws Error where it cannot start.
void run_serve(const Config& config);

/// The web client's folder: what is configured, else the first of the places beside the executable
/// and in /usr/share that has an index.html; empty where none has.
std::filesystem::path find_web_root(const std::filesystem::path& configured);

}  // namespace cutaway
