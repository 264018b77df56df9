#include "render/render_worker.h"

#include "core/log.h"

namespace cutaway {

namespace {

/// Frames whose pixels are on their way while the next are drawn.
constexpr std::size_t kReadbacksInFlight = 3;
/// Of an upload between two frames.
constexpr std::chrono::milliseconds kUploadTurn{10};

Pixels pixels_of(const RenderSettings& settings, gl::PixelReadback& readback) {
  return {settings.layout, settings.picture_size_px, readback.finish()};
}

/// What the one who asked is told of an exception; the log has the rest.
Error told(const std::exception& failure, std::uint64_t view) {
  if (const auto* error = dynamic_cast<const Error*>(&failure)) return *error;
  log().error("view {} could not be drawn: {}", view, failure.what());
  return Error({.code = "render-failed", .message = "the picture could not be drawn"});
}

/// What the receiver throws is its own failure and ends nobody else's frames.
void hand_over(const RenderJob& job, RenderOutcome outcome) {
  try {
    job.done(std::move(outcome));
  } catch (const std::exception& failure) {
    log().error("a frame of view {} was not taken: {}", job.view(), failure.what());
  }
}

}  // namespace

void RenderWorker::begin(RenderJob job) {
  volumes_.drop_unwanted();
  Pending pending{std::move(job), {}, Clock::now()};
  try {
    draw(pending);
    pending_.push_back(std::move(pending));
  } catch (const std::exception& failure) {
    return hand_over(pending.job, told(failure, pending.job.view()));
  }
  if (pending_.size() >= kReadbacksInFlight) finish(true);
}

void RenderWorker::draw(Pending& pending) {
  const RenderRequest& request = pending.job.request;
  check_device();
  if (!idle_readbacks_.empty()) {
    pending.readback = std::move(idle_readbacks_.back());
    idle_readbacks_.pop_back();
  }
  ViewState& view = views_[request.view];
  GpuVolume& volume = volumes_.use(request.volume);
  volume.upload_rest();
  pipeline_.render(view, *request.scene, volume, request.settings);
  FramePipeline::start_readback(view, request.settings.layout, pending.readback);
}

// The device tells of its loss once.
void RenderWorker::check_device() {
  lost_ = lost_ || context_.is_lost();
  if (lost_) throw Error({.code = "render-failed", .message = "the graphics device was lost"});
}

void RenderWorker::finish(bool wait) {
  while (!pending_.empty() && (wait || pending_.front().readback.is_ready())) {
    wait = false;
    Pending pending = std::move(pending_.front());
    pending_.pop_front();
    deliver(pending);
  }
}

void RenderWorker::deliver(Pending& pending) {
  const RenderRequest& request = pending.job.request;
  try {
    RenderedFrame frame{.pixels = pixels_of(request.settings, pending.readback),
                        .label = request.label};
    const auto spent =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - pending.begun);
    frame.render_us = static_cast<std::uint32_t>(spent.count());
    idle_readbacks_.push_back(std::move(pending.readback));
    hand_over(pending.job, std::move(frame));
  } catch (const std::exception& failure) {
    hand_over(pending.job, told(failure, request.view));
  }
}

void RenderWorker::upload_some() {
  if (uploads_.empty()) return;
  UploadJob& job = uploads_.front();
  try {
    if (!advance(job)) return;
    job.done.set_value();
  } catch (...) {
    volumes_.drop(job.volume.get());
    job.done.set_exception(std::current_exception());
  }
  uploads_.pop_front();
}

/// True once the whole volume is on the device.
bool RenderWorker::advance(const UploadJob& job) {
  check_device();
  GpuVolume& volume = volumes_.use(job.volume);
  const auto until = Clock::now() + kUploadTurn;
  while (!volume.is_complete() && Clock::now() < until) {
    throw_if_cancelled(job.stop);
    volume.upload_slab();
    if (job.progress) job.progress(LoadStage::upload, volume.uploaded());
  }
  return volume.is_complete();
}

}  // namespace cutaway
