// The process's log: standard error, one line an event.
#pragma once

#include <spdlog/spdlog.h>

namespace cutaway {

/// Thread-safe. Level and format are set once by `main`.
spdlog::logger& log();

}  // namespace cutaway
