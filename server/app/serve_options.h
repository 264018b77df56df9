// The command line of `cutaway serve`.
#pragma once

#include <CLI/CLI.hpp>

#include "app/serve_command.h"

namespace cutaway {

/// Adds the subcommand; parsing runs it. What the command line says goes before what the
/// configuration file says.
void add_serve(CLI::App& app);

}  // namespace cutaway
