// The process's log: standard error, one line an event. It never waits for whoever reads it.
#pragma once

#include <spdlog/spdlog.h>

namespace cutaway {

/// Thread-safe. Control characters in a message are escaped (printable.h), so that an event stays
/// one line whoever's words it repeats. Its level is set once by `run_serve`.
spdlog::logger& log();

}  // namespace cutaway
