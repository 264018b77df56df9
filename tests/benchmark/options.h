// The command line of cutaway-benchmark.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/frame_timing.h"

namespace cutaway::benchmark {

struct Options {
  std::vector<std::string> sizes = {"512x512", "1280x720", "1920x1080"};
  std::vector<int> phantom_sizes_voxels = {256};
  std::optional<std::filesystem::path> data;
  std::vector<std::string> volumes;
  std::vector<std::string> cases;
  std::vector<int> jpeg_threads;  ///< where there are any, JPEG is measured and frames are not
  std::string json_path;
  std::string task_folder;
  FrameBudget budget;
  bool require_gpu = false;
};

void add_options(CLI::App& app, Options& options);

/// "1280x720". Throws Error naming --sizes.
Viewport parse_size(const std::string& text);

/// Whether a name is one of those that were asked for by a part of it; all are where none was.
bool is_wanted(const std::string& name, const std::vector<std::string>& parts);

}  // namespace cutaway::benchmark
