// Times frames of a scene under a moving camera, and the stages that they are made of.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/frame_cases.h"
#include "gl/gpu_timer.h"
#include "render/frame_pipeline.h"

namespace cutaway::benchmark {

struct StageTime {
  std::string stage;
  double median_ms = 0.0;
};

struct FrameTime {
  int frames = 0;
  double median_ms = 0.0;  ///< the whole frame, from the scene to JPEG bytes
  double p95_ms = 0.0;
  double device_ms = 0.0;         ///< median that the renderer works, up to the read-back
  std::vector<StageTime> stages;  ///< in the pipeline's order
  double jpeg_bytes = 0.0;        ///< median
};

/// How long a case may take: until `seconds` are over, half of them for the whole frame and half
/// for the stages, but `least` whole frames at least, `least_for_stages` more, and `most` of each
/// at most.
struct FrameBudget {
  double seconds = 1.0;
  int least = 5;
  int least_for_stages = 5;
  int most = 200;
};

/// On the thread whose context is current. Interactive quality: one ray a pixel, a step of one
/// voxel, 4:2:0 at quality 80.
class FrameTiming {
 public:
  FrameTiming(std::shared_ptr<const LoadedVolume> volume, int max_texture_size);

  /// The camera turns by one degree a frame about the patient's axis, so that nothing is kept from
  /// frame to frame that a user's hand would not keep.
  FrameTime measure(const FrameCase& frame_case, Viewport size, const FrameBudget& budget);

  /// The case from the front, at full resolution.
  Picture picture(const FrameCase& frame_case, Viewport size, PixelLayout layout);

  /// What another renderer has to draw to do the work of a case without a lens, from the front.
  void write_task(const FrameCase& frame_case, Viewport size, const std::filesystem::path& folder);

 private:
  using Clock = std::chrono::steady_clock;
  Scene turned(const Scene& front, int degrees) const;
  std::size_t draw(const Scene& scene);
  void measure_whole(const Scene& front, const FrameBudget& budget, FrameTime& time);
  void measure_stages(const Scene& front, const FrameBudget& budget, FrameTime& time);

  std::shared_ptr<const LoadedVolume> loaded_;
  GpuVolume volume_;
  FramePipeline pipeline_;
  ViewState view_;
  gl::PixelReadback readback_;
  gl::GpuTimer timer_;
};

}  // namespace cutaway::benchmark
