#include "benchmark/options.h"

#include <algorithm>
#include <cstdio>

#include "core/error.h"

namespace cutaway::benchmark {

namespace {

constexpr int kMostThreads = 1024;

}  // namespace

void add_options(CLI::App& app, Options& options) {
  app.add_option("--sizes", options.sizes, "Picture sizes, WIDTHxHEIGHT")->capture_default_str();
  app.add_option("--phantom-size", options.phantom_sizes_voxels,
                 "Voxels an edge of the phantoms; each is measured at each of these sizes")
      ->capture_default_str();
  app.add_option("--data", options.data, "Folder whose CTs are measured too");
  app.add_option("--volumes", options.volumes, "Parts of the names of those to measure");
  app.add_option("--cases", options.cases, "Parts of the names of those to measure");
  app.add_option("--jpeg-threads", options.jpeg_threads,
                 "Measure JPEG instead of frames, with these numbers of threads")
      ->check(CLI::Range(1, kMostThreads));
  app.add_option("--json", options.json_path, "File for the figures as JSON");
  app.add_option("--write-task", options.task_folder,
                 "Folder for what another renderer needs to draw the last case without a lens");
  app.add_option("--seconds", options.budget.seconds, "For each case")->capture_default_str();
  app.add_option("--frames", options.budget.most, "For each case at most")->capture_default_str();
  app.add_option("--least-frames", options.budget.least, "Whole frames for each case at least")
      ->capture_default_str();
  app.add_flag("--require-gpu", options.require_gpu, "Refuse software rendering");
}

Viewport parse_size(const std::string& text) {
  Viewport size;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%dx%d%c", &size.width_px, &size.height_px, &rest);
  if (read == 2 && size.width_px >= 1 && size.height_px >= 1) return size;
  throw Error({.code = ErrorCode::out_of_range,
               .message = "this is no picture size",
               .field = "--sizes",
               .expected = "WIDTHxHEIGHT in pixels",
               .received = text});
}

bool is_wanted(const std::string& name, const std::vector<std::string>& parts) {
  return parts.empty() || std::ranges::any_of(parts, [&](const std::string& part) {
           return name.find(part) != std::string::npos;
         });
}

}  // namespace cutaway::benchmark
