// The one thread that owns a GPU's context: takes jobs in fair turn, draws, reads back without
// stalling.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "gl/context.h"
#include "render/job_queue.h"
#include "render/render_limits.h"
#include "render/render_settings.h"
#include "render/upload_job.h"
#include "scene/scene.h"
#include "volume/loaded_volume.h"

namespace cutaway {

struct RenderRequest {
  std::uint64_t view = 0;   ///< names the buffers kept between its jobs
  std::uint64_t share = 0;  ///< views of one share have as much of the device together as another
  std::string owner;        ///< whose view it is, for the log
  std::shared_ptr<const LoadedVolume> volume;
  std::shared_ptr<const Scene> scene;
  RenderSettings settings;
  std::shared_ptr<const void> label;  ///< the caller's own, handed back with the frame
  /// Given up, even while it is drawn, when a newer request of the view waits; else it is finished.
  bool yields = false;
  /// What stays in the buffers serves the view's next frame; else they are best kept small.
  bool is_followed = true;
};

struct RenderedFrame {
  Picture picture;
  std::uint32_t render_us = 0;  ///< from the job's begin until its pixels had arrived
  bool cast_rays = false;       ///< else what was kept of the view's last frame was enough
  std::shared_ptr<const void> label;
};

struct RenderReplaced {};

using RenderOutcome = std::variant<RenderedFrame, RenderReplaced, Error>;

struct RenderJob {
  RenderRequest request;
  /// Called once, on the render thread or the thread that submits a newer job or releases the view;
  /// must return quickly.
  std::function<void(RenderOutcome)> done;

  std::uint64_t view() const { return request.view; }
};

class RenderWorker;

struct RendererInfo {
  std::string renderer;
  std::string version;
  bool is_software = false;
  int largest_edge_voxels = 0;  ///< of a volume
  RenderLimits limits;          ///< those in force
};

/// Thread-safe. Destroying it ends waiting jobs as replaced and uploads as cancelled.
class RenderThread {
 public:
  /// Returns when the context works; throws what creating it threw.
  RenderThread(const gl::ContextOptions& options, const RenderLimits& limits);
  ~RenderThread();

  const RendererInfo& info() const { return info_; }

  /// True once the graphics device was lost: every job ends as an error from then on.
  bool is_lost() const { return lost_; }

  /// A job that waits for the same view is replaced by the newer one.
  void submit(RenderJob job);

  /// Puts `request` in the place of its view's waiting one, whose `done` stays. False where none
  /// waits.
  bool renew(const RenderRequest& request);

  /// Puts a volume on the device, some slabs at a time between frames, and returns when it is
  /// there; there it stays for as long as anyone holds it. A frame that shows it before then waits
  /// for the whole of it. `progress` is called on the render thread. Throws Error, or Cancelled
  /// when stopped.
  void upload(std::shared_ptr<const LoadedVolume> volume, ProgressSink progress,
              std::stop_token stop);

  /// Forgets the view's buffers; a job that waits or is being drawn ends as replaced. One that is
  /// submitted later is drawn.
  void release(std::uint64_t view);

 private:
  void serve(RenderWorker& worker, const std::stop_token& stop);
  void take_inbox(RenderWorker& worker);

  RendererInfo info_;
  JobQueue<RenderJob> queue_;
  std::mutex inbox_mutex_;
  std::vector<UploadJob> uploads_;  ///< not begun; taken between frames
  std::atomic<bool> lost_ = false;
  std::jthread thread_;
};

}  // namespace cutaway
