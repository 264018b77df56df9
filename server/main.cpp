// Wiring only: the command line, and who is handed what.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app/commands.h"
#include "core/printable.h"
#include "core/process.h"

int main(int argc, char** argv) {
  cutaway::keep_standard_streams();
  CLI::App app(
      "Renders medical volumes as focus and context illustrations. Not for diagnostic use.",
      "cutaway");
  // Not required of CLI11 itself, which would ask for one before it names a word that it does not
  // know.
  app.require_subcommand(0, 1);
  app.callback([&app] {
    if (app.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
  });
  app.set_version_flag("--version", "cutaway " CUTAWAY_VERSION);
  cutaway::add_commands(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::RuntimeError& ended) {
    return ended.get_exit_code();
  } catch (const CLI::ParseError& usage) {
    // CLI11 prints help and version too, as "errors" with code 0.
    return app.exit(usage) == 0 ? 0 : 2;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "cutaway: %s\n", cutaway::printable(failure.what()).c_str());
    return 1;
  }
}
