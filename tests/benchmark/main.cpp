// cutaway-benchmark: times frames and stages for each volume, size and configuration.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "benchmark/report.h"
#include "benchmark/volumes.h"
#include "core/error.h"
#include "gl/context.h"

namespace cutaway::benchmark {
namespace {

struct Options {
  std::vector<std::string> sizes = {"512x512", "1280x720", "1920x1080"};
  int phantom_size_voxels = 256;
  std::optional<std::filesystem::path> data;
  std::vector<std::string> volumes;
  std::vector<std::string> cases;
  std::string json_path;
  std::string task_folder;
  FrameBudget budget;
  bool require_gpu = false;
};

Viewport parse_size(const std::string& text) {
  Viewport size;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &size.width_px, &size.height_px, &rest);
  if (read == 2 && size.width_px >= 1 && size.height_px >= 1) return size;
  throw Error({.code = "out-of-range",
               .message = "this is no picture size",
               .field = "--sizes",
               .expected = "WIDTHxHEIGHT in pixels",
               .received = text});
}

/// Whether a name is one of those that were asked for by a part of it; all are where none was.
bool is_wanted(const std::string& name, const std::vector<std::string>& parts) {
  return parts.empty() || std::ranges::any_of(parts, [&](const std::string& part) {
           return name.find(part) != std::string::npos;
         });
}

void measure_volume(const NamedVolume& volume, const Options& options, const gl::Context& context,
                    Report& report) {
  const auto loaded = volume.load();
  report.begin_volume(volume.name, loaded->volume);
  FrameTiming timing(loaded, context.max_3d_texture_size());
  for (const std::string& size_text : options.sizes) {
    const Viewport size = parse_size(size_text);
    report.begin_size(size);
    for (const FrameCase& frame_case : frame_cases()) {
      if (!is_wanted(frame_case.name, options.cases)) continue;
      report.add(frame_case.name, timing.measure(frame_case, size, options.budget));
      if (!options.task_folder.empty() && frame_case.has_no_lens())
        timing.write_task(frame_case, size, options.task_folder);
    }
  }
}

void write_json(const Json& json, const std::string& path) {
  std::ofstream file(path);
  file << json.dump(2) << '\n';
  file.close();
  if (!file)
    throw Error({.code = "internal", .message = "the report cannot be written", .field = path});
}

void run(const Options& options) {
  const auto context = gl::Context::create({.require_gpu = options.require_gpu});
  Machine machine = this_machine();
  machine.renderer = context->renderer();
  machine.software_renderer = context->is_software();
  Report report(machine);
  for (const NamedVolume& volume : volumes_to_measure(options.phantom_size_voxels, options.data)) {
    if (is_wanted(volume.name, options.volumes)) measure_volume(volume, options, *context, report);
  }
  if (!options.json_path.empty()) write_json(report.json(), options.json_path);
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--sizes", options.sizes, "Picture sizes, WIDTHxHEIGHT")->capture_default_str();
  app.add_option("--phantom-size", options.phantom_size_voxels, "Voxels an edge of the phantoms")
      ->capture_default_str();
  app.add_option("--data", options.data, "Folder whose CTs are measured too");
  app.add_option("--volumes", options.volumes, "Parts of the names of those to measure");
  app.add_option("--cases", options.cases, "Parts of the names of those to measure");
  app.add_option("--json", options.json_path, "File for the figures as JSON");
  app.add_option("--write-task", options.task_folder,
                 "Folder for what another renderer needs to draw the last case without a lens");
  app.add_option("--seconds", options.budget.seconds, "For each case")->capture_default_str();
  app.add_option("--frames", options.budget.most, "For each case at most")->capture_default_str();
  app.add_option("--least-frames", options.budget.least, "Whole frames for each case at least")
      ->capture_default_str();
  app.add_flag("--require-gpu", options.require_gpu, "Refuse software rendering");
}

}  // namespace
}  // namespace cutaway::benchmark

int main(int argc, char** argv) {
  CLI::App app("Times frames and their stages");
  cutaway::benchmark::Options options;
  cutaway::benchmark::add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    cutaway::benchmark::run(options);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
