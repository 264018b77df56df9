// cutaway-benchmark: times frames and stages for each volume, size and configuration, or JPEG.
#include <fstream>
#include <iostream>

#include "benchmark/options.h"
#include "benchmark/report.h"
#include "benchmark/volumes.h"
#include "core/error.h"
#include "gl/context.h"
#include "session/quality_control.h"

namespace cutaway::benchmark {
namespace {

void measure_frames(FrameTiming& timing, Viewport size, const Options& options, Report& report) {
  report.begin_size(size);
  for (const FrameCase& frame_case : frame_cases()) {
    if (!is_wanted(frame_case.name, options.cases)) continue;
    report.add(frame_case.name, timing.measure(frame_case, size, options.budget));
    if (!options.task_folder.empty() && frame_case.has_no_lens())
      timing.write_task(frame_case, size, options.task_folder);
  }
}

/// The flagship's picture as the server sends it while it moves, and at rest.
void measure_jpegs(FrameTiming& timing, Viewport size, const Options& options, Report& report) {
  for (const FrameQuality& quality : {FrameQuality(), still_quality(SessionSettings(), size)}) {
    const bool halved = quality.chroma == ChromaSampling::yuv420;
    const Picture picture =
        timing.picture(flagship_case(), size, halved ? PixelLayout::yuv420 : PixelLayout::yuv444);
    report.add_jpeg(
        picture, quality.jpeg_quality,
        measure_jpeg(picture, quality.jpeg_quality, options.jpeg_threads, options.budget.seconds));
  }
}

void measure_volume(const NamedVolume& volume, const Options& options, const gl::Context& context,
                    Report& report) {
  const auto loaded = volume.load();
  report.begin_volume(volume.name, loaded->volume);
  FrameTiming timing(loaded, context.max_3d_texture_size());
  for (const std::string& size_text : options.sizes) {
    const Viewport size = parse_size(size_text);
    if (options.jpeg_threads.empty()) {
      measure_frames(timing, size, options, report);
    } else {
      measure_jpegs(timing, size, options, report);
    }
  }
}

void write_json(const Json& json, const std::string& path) {
  std::ofstream file(path);
  file << json.dump(2) << '\n';
  file.close();
  if (!file)
    throw Error(
        {.code = ErrorCode::internal, .message = "the report cannot be written", .field = path});
}

void run(const Options& options) {
  const auto context = gl::Context::create({.require_gpu = options.require_gpu});
  Machine machine = this_machine();
  machine.renderer = context->renderer();
  machine.software_renderer = context->is_software();
  Report report(machine);
  for (const NamedVolume& volume : volumes_to_measure(options.phantom_sizes_voxels, options.data)) {
    if (is_wanted(volume.name, options.volumes)) measure_volume(volume, options, *context, report);
  }
  if (!options.json_path.empty()) write_json(report.json(), options.json_path);
}

}  // namespace
}  // namespace cutaway::benchmark

int main(int argc, char** argv) {
  CLI::App app("Times frames and their stages, or JPEG");
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
