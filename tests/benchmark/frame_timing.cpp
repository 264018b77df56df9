#include "benchmark/frame_timing.h"

#include <glm/gtc/matrix_transform.hpp>

#include "benchmark/samples.h"
#include "benchmark/yardstick_task.h"
#include "encode/jpeg.h"
#include "render/loaded_facts.h"
#include "scene/resolve.h"

namespace cutaway::benchmark {

namespace {

constexpr int kJpegQuality = 80;
constexpr PixelLayout kLayout = PixelLayout::yuv420;

/// Times by name, in the order in which the names first came.
class StageSamples {
 public:
  void begin_frame() {
    for (auto& [stage, times_ms] : samples_) times_ms.push_back(0.0);
  }

  /// A stage that runs twice in a frame, once for each branch, adds up.
  void add(const std::string& stage, double time_ms) {
    for (auto& [name, times_ms] : samples_) {
      if (name != stage) continue;
      times_ms.back() += time_ms;
      return;
    }
    samples_.push_back({stage, {time_ms}});
  }

  std::vector<StageTime> medians() const {
    std::vector<StageTime> result;
    result.reserve(samples_.size());
    for (const auto& [stage, times_ms] : samples_) result.push_back({stage, median(times_ms)});
    return result;
  }

 private:
  std::vector<std::pair<std::string, std::vector<double>>> samples_;
};

double milliseconds_between(std::chrono::steady_clock::time_point begin,
                            std::chrono::steady_clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Whether another frame fits a half of the budget.
bool wants_more(const FrameBudget& budget, int least, int frames, double spent_ms) {
  if (frames < least) return true;
  return frames < budget.most && spent_ms < 500.0 * budget.seconds;
}

Picture picture_of(Viewport size, std::vector<PixelPlane> planes) {
  return {kLayout, {size.width_px, size.height_px}, std::move(planes)};
}

RenderSettings interactive_settings(Viewport size, PixelLayout layout = kLayout) {
  return {
      .picture_size_px = {size.width_px, size.height_px}, .light = kQuickLight, .layout = layout};
}

}  // namespace

FrameTiming::FrameTiming(std::shared_ptr<const LoadedVolume> volume, int max_texture_size)
    : loaded_(std::move(volume)), volume_(loaded_, max_texture_size) {
  volume_.upload_rest();
}

FrameTime FrameTiming::measure(const FrameCase& frame_case, Viewport size,
                               const FrameBudget& budget) {
  const Scene front = resolve_scene(frame_case.scene, facts_of(loaded_), size);
  FrameTime time;
  draw(front);  // compiles, allocates and uploads what the first frame has to
  measure_whole(front, budget, time);
  measure_stages(front, budget, time);
  return time;
}

Picture FrameTiming::picture(const FrameCase& frame_case, Viewport size, PixelLayout layout) {
  const Scene front = resolve_scene(frame_case.scene, facts_of(loaded_), size);
  pipeline_.render(view_, front, volume_, interactive_settings(size, layout));
  FramePipeline::start_readback(view_, layout, readback_);
  return {layout, {size.width_px, size.height_px}, readback_.finish()};
}

void FrameTiming::write_task(const FrameCase& frame_case, Viewport size,
                             const std::filesystem::path& folder) {
  const Scene front = resolve_scene(frame_case.scene, facts_of(loaded_), size);
  pipeline_.render(view_, front, volume_, interactive_settings(size));
  Silhouette silhouette{size, {}};
  for (const glm::vec4& surface : FramePipeline::read_surface(view_, kContext))
    silhouette.pixels.push_back(surface.w >= 0.0F ? 255 : 0);
  write_yardstick_task(folder, loaded_->volume, front, silhouette);
}

Scene FrameTiming::turned(const Scene& front, int degrees) const {
  Scene scene = front;
  const glm::dmat4 turn =
      glm::rotate(glm::dmat4(1.0), glm::radians(double(degrees)), glm::dvec3(0.0, 0.0, 1.0));
  const glm::dvec3 arm_mm = front.camera.eye_mm - front.camera.target_mm;
  scene.camera.eye_mm = front.camera.target_mm + glm::dvec3(turn * glm::dvec4(arm_mm, 0.0));
  return scene;
}

std::size_t FrameTiming::draw(const Scene& scene) {
  timer_.begin();
  pipeline_.render(view_, scene, volume_, interactive_settings(scene.viewport));
  FramePipeline::start_readback(view_, kLayout, readback_);
  timer_.end();
  return encode_jpeg(picture_of(scene.viewport, readback_.finish()), kJpegQuality).bytes.size();
}

void FrameTiming::measure_whole(const Scene& front, const FrameBudget& budget, FrameTime& time) {
  std::vector<double> frames_ms;
  std::vector<double> device_ms;
  std::vector<double> bytes;
  double spent_ms = 0.0;
  while (wants_more(budget, budget.least, static_cast<int>(frames_ms.size()), spent_ms)) {
    const Scene scene = turned(front, static_cast<int>(frames_ms.size()) + 1);
    const auto begun = Clock::now();
    bytes.push_back(static_cast<double>(draw(scene)));
    frames_ms.push_back(milliseconds_between(begun, Clock::now()));
    device_ms.push_back(static_cast<double>(timer_.elapsed_ns()) / 1e6);
    spent_ms += frames_ms.back();
  }
  time.frames = static_cast<int>(frames_ms.size());
  time.median_ms = median(frames_ms);
  time.p95_ms = quantile(frames_ms, 0.95);
  time.device_ms = median(device_ms);
  time.jpeg_bytes = median(bytes);
}

// The device is waited for after each stage, which takes away what stages would do at the same
// time: stages add up to a little more than the frame.
void FrameTiming::measure_stages(const Scene& front, const FrameBudget& budget, FrameTime& time) {
  StageSamples samples;
  auto last = Clock::now();
  const auto stage_ended = [&](const std::string& stage) {
    glFinish();
    const auto now = Clock::now();
    samples.add(stage, milliseconds_between(last, now));
    last = now;
  };
  pipeline_.observe(stage_ended);
  const auto begun = Clock::now();
  for (int i = 0;
       wants_more(budget, budget.least_for_stages, i, milliseconds_between(begun, Clock::now()));
       ++i) {
    const Scene scene = turned(front, -1 - i);
    samples.begin_frame();
    last = Clock::now();
    pipeline_.render(view_, scene, volume_, interactive_settings(scene.viewport));
    FramePipeline::start_readback(view_, kLayout, readback_);
    const Picture picture = picture_of(scene.viewport, readback_.finish());
    stage_ended("read back");
    encode_jpeg(picture, kJpegQuality);
    stage_ended("JPEG");
  }
  pipeline_.observe({});
  time.stages = samples.medians();
}

}  // namespace cutaway::benchmark
