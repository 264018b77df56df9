// What the render thread does with a job; lives on that thread only.
#pragma once

#include <chrono>
#include <deque>
#include <map>

#include "render/device_volumes.h"
#include "render/frame_pipeline.h"
#include "render/render_thread.h"

namespace cutaway {

class RenderWorker {
 public:
  RenderWorker(const gl::Context& context, std::uint64_t volume_bytes)
      : context_(context), volumes_(context.max_3d_texture_size(), volume_bytes) {}

  /// Draws and starts the read-back. A failure ends this job alone.
  void begin(RenderJob job);

  /// Puts a volume behind those that are on their way to the device.
  void add(UploadJob job) { uploads_.push_back(std::move(job)); }
  bool has_uploads() const { return !uploads_.empty(); }
  /// Goes on with the oldest of them for a few milliseconds. A failure ends this upload alone.
  void upload_some();

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

  void check_device();
  bool advance(const UploadJob& job);
  void draw(Pending& pending);
  void deliver(Pending& pending);

  const gl::Context& context_;
  bool lost_ = false;
  FramePipeline pipeline_;
  std::map<std::uint64_t, ViewState> views_;
  DeviceVolumes volumes_;
  std::deque<Pending> pending_;    ///< oldest first
  std::deque<UploadJob> uploads_;  ///< oldest first
  std::vector<gl::PixelReadback> idle_readbacks_;
};

}  // namespace cutaway
