// `cutaway serve`: volumes, a renderer and a listener, put together.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/config.h"
#include "session/ends.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// What is loaded under an id; null where nothing is. Thread-safe.
using VolumeLookup = std::function<std::shared_ptr<const LoadedVolume>(const std::string&)>;

/// Makes what renders; throws where there is no renderer as the settings want it. The lookup
/// outlives it.
using FrameSourceFactory =
    std::function<std::unique_ptr<FrameSource>(const RendererSettings&, VolumeLookup)>;

/// Serves until SIGINT or SIGTERM. Prints "Cutaway is at http://..." on standard output once
/// clients can come. Throws Error where it cannot start.
void run_serve(const Config& config, const FrameSourceFactory& make_frames);

/// The web client's folder: what is configured, else the first of the places beside the executable
/// and in /usr/share that has an index.html; empty where none has.
std::filesystem::path find_web_root(const std::filesystem::path& configured);

}  // namespace cutaway
