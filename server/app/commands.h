// The subcommands of the executable.
#pragma once

#include <CLI/CLI.hpp>

namespace cutaway {

/// Adds `serve`, `info` and `render` with their options; parsing runs the one that was given.
void add_commands(CLI::App& app);

}  // namespace cutaway
