// What the render thread does with a job; lives on that thread only.
#pragma once

#include <chrono>
#include <deque>
#include <map>

#include "render/frame_pipeline.h"
#include "render/render_thread.h"

namespace cutaway {

class RenderWorker {
 public:
  explicit RenderWorker(const gl::Context& context) : context_(context) {}

  /// Draws and starts the read-back. A failure ends this job alone.
  void begin(RenderJob job);

  bool has_pending() const { return !pending_.empty(); }
  /// Hands over every frame whose pixels have arrived; waits for the oldest where `wait` says so.
  void finish(bool wait);

  /// True once the graphics device was lost; every job fails from then on.
  bool is_lost() const { return lost_; }

  void release(std::uint64_t view) { views_.erase(view); }

 private:
  using Clock = std::chrono::steady_clock;
  struct Pending {
    RenderJob job;
    gl::PixelReadback readback;
    Clock::time_point begun;
  };

  GpuVolume& volume_for(const std::shared_ptr<const LoadedVolume>& loaded);
  void drop_unused_volumes();
  void draw(Pending& pending);
  static void deliver(Pending& pending);

  const gl::Context& context_;
  bool lost_ = false;
  FramePipeline pipeline_;
  std::map<std::uint64_t, ViewState> views_;
  std::map<std::shared_ptr<const LoadedVolume>, GpuVolume> volumes_;
  std::deque<Pending> pending_;  ///< oldest first
  std::vector<gl::PixelReadback> idle_readbacks_;
};

}  // namespace cutaway
