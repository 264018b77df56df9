// What the render thread does with its jobs; lives on that thread only.
#pragma once

#include <chrono>
#include <deque>
#include <list>
#include <span>

#include "gl/fence.h"
#include "render/device_volumes.h"
#include "render/frame_pipeline.h"
#include "render/picture_parts.h"
#include "render/render_thread.h"
#include "render/view_cache.h"
#include "render/view_turns.h"

namespace cutaway {

class RenderWorker {
 public:
  /// `limits` as limits_for gives them.
  RenderWorker(const gl::Context& context, const RenderLimits& limits);

  /// Draws a step of the frame whose view's turn it is, of those that were begun and those that
  /// wait in the queue; frames that are complete go on to their read-back. False where there is
  /// none. A failure ends its job alone.
  bool draw_some(JobQueue<RenderJob>& queue);

  /// Puts a volume behind those that are on their way to the device.
  void add(UploadJob job) { uploads_.push_back(std::move(job)); }
  bool has_uploads() const { return !uploads_.empty(); }
  /// Goes on with the oldest of them for a few milliseconds. A failure ends this upload alone.
  void upload_some();

  /// Hands over every frame whose pixels have arrived; waits for the oldest where `wait` says so.
  void finish(bool wait);

  bool is_idle() const { return drawing_.empty() && pending_.empty() && uploads_.empty(); }
  /// True once the graphics device was lost; every job fails from then on.
  bool is_lost() const { return lost_; }

  /// Forgets the views; frames of them that are being drawn end as replaced.
  void release(std::span<const std::uint64_t> views);
  /// Ends every frame: those that are complete as frames, the others as replaced.
  void give_up();
  /// Frees what nobody has asked for in a while.
  void tidy();

 private:
  using Clock = std::chrono::steady_clock;
  /// A frame from its begin until the last of its pixels have arrived.
  struct Commission {
    Commission(RenderJob asked, Clock::time_point now) : job(std::move(asked)), begun(now) {}
    RenderJob job;
    Clock::time_point begun;
    PictureParts parts;
    bool cast_rays = false;
    bool is_ended = false;  ///< its outcome was handed over: pixels on their way are in vain
  };
  struct Drawing {
    std::shared_ptr<Commission> commission;
    std::shared_ptr<GpuVolume> volume;  ///< held: the volumes' limit must not take it away now
    FramePlan plan;                     ///< of the part at hand
    std::size_t part = 0;

    std::uint64_t view() const { return commission->job.view(); }
    const RenderRequest& request() const { return commission->job.request; }
    ShareOfView who() const { return {view(), request().share}; }
  };
  struct Pending {
    std::shared_ptr<Commission> commission;
    std::size_t part;
    gl::PixelReadback readback;
  };
  using Place = std::list<Drawing>::iterator;

  std::vector<ShareOfView> views_that_wait(const JobQueue<RenderJob>& queue) const;
  Place find(std::uint64_t view);
  void release(std::uint64_t view);
  bool begin(RenderJob job);
  void step(Place drawing);
  void end(Place drawing, RenderOutcome outcome);
  void plan_part(Drawing& drawing);
  void read_back(const Drawing& drawing);
  void keep_pace();
  void check_device();
  bool advance(const UploadJob& job);
  void deliver(Pending& pending);
  PartLimits part_limits(bool is_followed) const;
  static void conclude(Commission& commission, RenderOutcome outcome);
  static RenderedFrame frame_of(Commission& commission);
  void keep(gl::PixelReadback readback);

  const gl::Context& context_;
  std::int64_t step_cost_;
  std::uint64_t view_bytes_;
  bool lost_ = false;
  FramePipeline pipeline_;
  ViewCache views_;
  DeviceVolumes volumes_;
  ViewTurns turns_;
  std::list<Drawing> drawing_;     ///< one a view, in the order in which they were begun
  std::deque<gl::Fence> steps_;    ///< that the device has not come to, oldest first
  std::deque<Pending> pending_;    ///< oldest first
  std::deque<UploadJob> uploads_;  ///< oldest first
  std::vector<gl::PixelReadback> idle_readbacks_;
};

}  // namespace cutaway
