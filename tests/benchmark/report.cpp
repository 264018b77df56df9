#include "benchmark/report.h"

namespace cutaway::benchmark {

Report::Report(const Machine& machine)
    : json_({{"machine",
              {{"processor", machine.processor},
               {"cores", machine.cores},
               {"renderer", machine.renderer},
               {"software_renderer", machine.software_renderer},
               {"compiler", machine.compiler}}},
             {"frames", Json::array()}}) {
  std::printf("%s, %d cores; %s%s\n", machine.processor.c_str(), machine.cores,
              machine.renderer.c_str(), machine.software_renderer ? " (software)" : "");
}

void Report::begin_volume(const std::string& name, const Volume& volume) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  std::printf("\n%s, %d x %d x %d\n", name.c_str(), size.x, size.y, size.z);
  volume_ = name;
}

void Report::begin_size(Viewport size) {
  std::printf("  %d x %d: median ms a frame (95th percentile), of the renderer, then by stage\n",
              size.width_px, size.height_px);
  size_ = size;
}

void Report::add(const std::string& case_name, const FrameTime& time) {
  std::printf("    %-16s %8.2f (%7.2f) %8.2f ", case_name.c_str(), time.median_ms, time.p95_ms,
              time.device_ms);
  Json stages = Json::object();
  for (const StageTime& stage : time.stages) {
    std::printf("  %s %.2f", stage.stage.c_str(), stage.median_ms);
    stages[stage.stage] = stage.median_ms;
  }
  std::printf("\n");
  std::fflush(stdout);
  json_["frames"].push_back({{"volume", volume_},
                             {"size_px", {size_.width_px, size_.height_px}},
                             {"case", case_name},
                             {"frames", time.frames},
                             {"median_ms", time.median_ms},
                             {"p95_ms", time.p95_ms},
                             {"device_ms", time.device_ms},
                             {"stages_ms", stages},
                             {"jpeg_bytes", time.jpeg_bytes}});
}

}  // namespace cutaway::benchmark
