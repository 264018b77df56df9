// cutaway-load: many clients at once, as a script describes them, and whether its thresholds held.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <thread>

#include "load/progress_line.h"
#include "load/report_html.h"
#include "load/report_json.h"
#include "load/report_table.h"

namespace cutaway::load {
namespace {

constexpr int kHeld = 0;
constexpr int kNotHeld = 1;
constexpr int kWrongUsage = 2;

struct Options {
  std::string script;
  std::string url;
  std::optional<int> clients;
  std::optional<double> seconds;
  std::optional<double> ramp_s;
  int threads = 0;
  std::string json_path;
  std::string html_path;
  std::optional<int> watch_pid;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("script", options.script, "Load script (protocol/schema/load-script.schema.json)")
      ->required()
      ->type_name("SCRIPT.json");
  app.add_option("--url", options.url, "Where the server is")
      ->required()
      ->type_name("ws://HOST:PORT/ws");
  app.add_option("--clients", options.clients, "How many [the script's]")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000));
  app.add_option("--seconds", options.seconds, "How long the run takes [the script's]")
      ->type_name("S")
      ->check(CLI::Range(0.1, 86'400.0));
  app.add_option("--ramp", options.ramp_s, "Seconds over which the clients start [the script's]")
      ->type_name("S")
      ->check(CLI::Range(0.0, 86'400.0));
  app.add_option("--threads", options.threads,
                 "Of the load client [one for 100 clients, at most the cores]")
      ->type_name("T")
      ->check(CLI::Range(1, 256));
  app.add_option("--json", options.json_path, "File for the report as JSON")->type_name("FILE");
  app.add_option("--html", options.html_path, "File for the report as a page")->type_name("FILE");
  app.add_option("--watch-pid", options.watch_pid, "Process whose memory is watched")
      ->type_name("PID")
      ->check(CLI::Range(1, 1 << 22));
}

int default_threads(int clients) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return std::clamp((clients + 99) / 100, 1, cores);
}

RunSettings settings_of(const Options& options, const Script& script) {
  RunSettings settings{.address = parse_address(options.url),
                       .clients = options.clients.value_or(script.clients),
                       .seconds = options.seconds.value_or(script.seconds),
                       .ramp_s = options.ramp_s.value_or(script.ramp_s),
                       .watch_pid = options.watch_pid};
  settings.threads = options.threads > 0 ? options.threads : default_threads(settings.clients);
  if (settings.ramp_s >= settings.seconds)
    throw std::invalid_argument("--ramp: expected less than --seconds, " +
                                std::to_string(settings.seconds) + "; came " +
                                std::to_string(settings.ramp_s));
  return settings;
}

void write(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

int report(const Options& options, const Script& script, const RunOutcome& outcome) {
  const Summary summary = summarise(script, outcome);
  const std::vector<Check> checks = judge(script.thresholds, summary);
  print_table(std::cout, script, summary, checks);
  write(options.json_path, json_report(script, summary, checks).dump(2) + "\n");
  write(options.html_path, html_report(script, summary, checks));
  return all_held(checks) ? kHeld : kNotHeld;
}

int run(const Options& options) {
  const Script script = read_script(options.script);
  const RunSettings settings = settings_of(options, script);
  if (settings.watch_pid && !resident_mib(*settings.watch_pid))
    throw std::runtime_error("--watch-pid: there is no process " +
                             std::to_string(*settings.watch_pid));
  return report(options, script,
                run_clients(script, settings, progress_line(settings.clients, settings.seconds)));
}

int wrong_usage(const std::string& words) {
  std::cerr << "cutaway-load: " << words << "\nIts options: cutaway-load --help\n";
  return kWrongUsage;
}

}  // namespace
}  // namespace cutaway::load

int main(int argc, char** argv) {
  using namespace cutaway::load;
  CLI::App app("Loads a Cutaway server with many clients and measures what each of them sees");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    return wrong_usage(error.what());
  }
  try {
    return run(options);
  } catch (const std::invalid_argument& error) {
    return wrong_usage(error.what());
  } catch (const std::exception& error) {
    std::cerr << "cutaway-load: " << error.what() << '\n';
    return kNotHeld;
  }
}
