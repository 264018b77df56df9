#include "benchmark/report.h"

#include "encode/jpeg.h"

namespace cutaway::benchmark {

Report::Report(const Machine& machine)
    : json_({{"machine",
              {{"processor", machine.processor},
               {"cores", machine.cores},
               {"renderer", machine.renderer},
               {"software_renderer", machine.software_renderer},
               {"compiler", machine.compiler}}},
             {"frames", Json::array()},
             {"jpeg", Json::array()}}) {
  std::printf("%s, %d cores; %s%s\n", machine.processor.c_str(), machine.cores,
              machine.renderer.c_str(), machine.software_renderer ? " (software)" : "");
}

void Report::begin_volume(const std::string& name, const Volume& volume) {
  const glm::ivec3 size = volume.geometry.size_voxels;
  std::printf("\n%s, %d x %d x %d\n", name.c_str(), size.x, size.y, size.z);
  std::fflush(stdout);
  volume_ = name;
  size_voxels_ = size;
}

void Report::begin_size(Viewport size) {
  std::printf("  %d x %d: median ms a frame (95th percentile), of the renderer, then by stage\n",
              size.width_px, size.height_px);
  size_ = size;
}

void Report::add(const std::string& case_name, const FrameTime& time) {
  std::printf("    %-20s %8.2f (%7.2f) %8.2f ", case_name.c_str(), time.median_ms, time.p95_ms,
              time.device_ms);
  Json stages = Json::object();
  for (const StageTime& stage : time.stages) {
    std::printf("  %s %.2f", stage.stage.c_str(), stage.median_ms);
    stages[stage.stage] = stage.median_ms;
  }
  std::printf("\n");
  std::fflush(stdout);
  json_["frames"].push_back({{"volume", volume_},
                             {"size_voxels", {size_voxels_.x, size_voxels_.y, size_voxels_.z}},
                             {"size_px", {size_.width_px, size_.height_px}},
                             {"case", case_name},
                             {"frames", time.frames},
                             {"median_ms", time.median_ms},
                             {"p95_ms", time.p95_ms},
                             {"device_ms", time.device_ms},
                             {"stages_ms", stages},
                             {"jpeg_bytes", time.jpeg_bytes}});
}

// Megabytes are 10^6 bytes of the planes that go in.
void Report::add_jpeg(const Picture& picture, int quality, const std::vector<JpegRate>& rates) {
  const char* chroma = picture.layout() == PixelLayout::yuv420 ? "4:2:0" : "4:4:4";
  const glm::ivec2 size = picture.size_px();
  const std::size_t jpeg_bytes = encode_jpeg(picture, quality).bytes.size();
  std::printf("  %d x %d, %s at quality %d, %zu bytes: threads, pictures a second, MB a second\n",
              size.x, size.y, chroma, quality, jpeg_bytes);
  for (const JpegRate& rate : rates) {
    const double megabytes = static_cast<double>(picture.bytes()) / 1e6;
    std::printf("    %4d %8.1f %8.1f\n", rate.threads, rate.pictures_per_second,
                rate.pictures_per_second * megabytes);
    json_["jpeg"].push_back({{"volume", volume_},
                             {"size_px", {size.x, size.y}},
                             {"chroma", chroma},
                             {"quality", quality},
                             {"jpeg_bytes", jpeg_bytes},
                             {"threads", rate.threads},
                             {"pictures_per_second", rate.pictures_per_second},
                             {"mb_per_second", rate.pictures_per_second * megabytes}});
  }
  std::fflush(stdout);
}

}  // namespace cutaway::benchmark
