#include "render/render_worker.h"

#include <algorithm>

#include "core/log.h"

namespace cutaway {

namespace {

/// Frames whose pixels are on their way while the next are drawn.
constexpr std::size_t kReadbacksInFlight = 3;
constexpr std::size_t kStepsInFlight = 2;
constexpr std::size_t kKeptReadbackBytes = std::size_t{16} << 20;
constexpr std::chrono::seconds kIdleViews{60};
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

RenderWorker::RenderWorker(const gl::Context& context, const RenderLimits& limits)
    : context_(context),
      step_cost_(limits.step),
      views_(limits.view_bytes),
      volumes_(context.max_3d_texture_size(), limits.volume_bytes) {}

bool RenderWorker::draw_some(JobQueue<RenderJob>& queue) {
  const std::vector<Waiting> waiting = views_that_wait(queue);
  if (waiting.empty()) return false;
  const std::uint64_t view = next_view(waiting);
  Place drawing = find(view);
  if (drawing != drawing_.end() && drawing->job.request.yields && queue.has(view)) {
    end(drawing, RenderReplaced{});
    drawing = drawing_.end();
  }
  if (drawing == drawing_.end()) {
    JobQueue<RenderJob>::Taken taken = queue.take(view);
    release(taken.released);
    if (!taken.job || !begin(std::move(*taken.job))) return true;  // it may have been taken back
    drawing = std::prev(drawing_.end());
  }
  step(drawing);
  return true;
}

// Frames that were begun come first: among views that have had equally much they are finished in
// that order. Where they take up the views' memory, no other is begun before one is finished.
std::vector<RenderWorker::Waiting> RenderWorker::views_that_wait(
    const JobQueue<RenderJob>& queue) const {
  std::vector<Waiting> views;
  for (const Drawing& drawing : drawing_)
    views.push_back({drawing.job.view(), drawing.job.request.share});
  if (!drawing_.empty() && !views_.has_room()) return views;
  queue.for_each([&views](const RenderJob& job) {
    if (std::ranges::find(views, job.view(), &Waiting::view) == views.end())
      views.push_back({job.view(), job.request.share});
  });
  return views;
}

// First the session, then the view: who has four pictures gets no more than who has one.
std::uint64_t RenderWorker::next_view(const std::vector<Waiting>& waiting) {
  std::vector<std::uint64_t> numbers;
  for (const Waiting& each : waiting) numbers.push_back(each.share);
  const std::uint64_t share = shares_.next(numbers);
  numbers.clear();
  for (const Waiting& each : waiting) {
    if (each.share == share) numbers.push_back(each.view);
  }
  return turns_.next(numbers);
}

void RenderWorker::charge(const RenderRequest& request, std::int64_t cost) {
  shares_.charge(request.share, cost);
  turns_.charge(request.view, cost);
}

RenderWorker::Place RenderWorker::find(std::uint64_t view) {
  return std::ranges::find_if(drawing_,
                              [=](const Drawing& each) { return each.job.view() == view; });
}

/// False where it has failed.
bool RenderWorker::begin(RenderJob job) {
  Drawing drawing{std::move(job), nullptr, {}, Clock::now()};
  const RenderRequest& request = drawing.job.request;
  ViewState& view = views_.pin(request.view);
  try {
    check_device();
    volumes_.show(request.view, request.volume);
    drawing.volume = volumes_.use(request.volume);
    drawing.volume->upload_rest();
    drawing.plan = pipeline_.plan(view, *request.scene, *drawing.volume, request.settings);
    drawing.cast_rays = drawing.plan.has(kRayCast);
    views_.keep_within_limit();
    drawing_.push_back(std::move(drawing));
    return true;
  } catch (const std::exception& failure) {
    views_.unpin(request.view);
    hand_over(drawing.job, told(failure, request.view));
    return false;
  }
}

void RenderWorker::step(Place drawing) {
  const std::uint64_t view = drawing->job.view();
  try {
    check_device();
    charge(drawing->job.request, drawing->plan.advance(step_cost_));
    keep_pace();
    if (!drawing->plan.is_done()) return;
    read_back(*drawing);
  } catch (const std::exception& failure) {
    return end(drawing, told(failure, view));
  }
  views_.unpin(view);
  drawing_.erase(drawing);
  if (pending_.size() >= kReadbacksInFlight) finish(true);
}

// The device may have a step or two ahead of it, or it would run dry, and no more, or a small frame
// would wait behind all that was asked for before it.
void RenderWorker::keep_pace() {
  steps_.push_back(gl::Fence::insert());
  if (steps_.size() <= kStepsInFlight) return;
  steps_.front().wait();
  steps_.pop_front();
}

void RenderWorker::read_back(Drawing& drawing) {
  gl::PixelReadback readback;
  if (!idle_readbacks_.empty()) {
    readback = std::move(idle_readbacks_.back());
    idle_readbacks_.pop_back();
  }
  const RenderRequest& request = drawing.job.request;
  FramePipeline::start_readback(views_.pinned(request.view), request.settings.layout, readback);
  pending_.push_back(
      {std::move(drawing.job), std::move(readback), drawing.begun, drawing.cast_rays});
}

void RenderWorker::end(Place drawing, RenderOutcome outcome) {
  views_.unpin(drawing->job.view());
  const RenderJob job = std::move(drawing->job);
  drawing_.erase(drawing);
  hand_over(job, std::move(outcome));
}

void RenderWorker::release(std::span<const std::uint64_t> views) {
  for (const std::uint64_t view : views) release(view);
}

void RenderWorker::release(std::uint64_t view) {
  if (const Place drawing = find(view); drawing != drawing_.end()) end(drawing, RenderReplaced{});
  views_.drop(view);
  volumes_.forget(view);
  turns_.forget(view);
  shares_.forget(view);  // a session's share goes by the name of its first view
}

void RenderWorker::give_up() {
  while (!drawing_.empty()) end(drawing_.begin(), RenderReplaced{});
  while (!pending_.empty()) finish(true);
}

void RenderWorker::tidy() {
  volumes_.drop_unwanted();
  views_.drop_idle(kIdleViews);
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
                        .cast_rays = pending.cast_rays,
                        .label = request.label};
    const auto spent =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - pending.begun);
    frame.render_us = static_cast<std::uint32_t>(spent.count());
    keep(std::move(pending.readback));
    hand_over(pending.job, std::move(frame));
  } catch (const std::exception& failure) {
    hand_over(pending.job, told(failure, request.view));
  }
}

// A large buffer is not kept for the small frames after it.
void RenderWorker::keep(gl::PixelReadback readback) {
  if (readback.capacity() <= kKeptReadbackBytes) idle_readbacks_.push_back(std::move(readback));
}

void RenderWorker::upload_some() {
  if (uploads_.empty()) return;
  UploadJob& job = uploads_.front();
  try {
    if (!advance(job)) return;
    job.done.set_value();
  } catch (...) {
    volumes_.drop(job.volume);
    job.done.set_exception(std::current_exception());
  }
  uploads_.pop_front();
}

/// True once the whole volume is on the device.
bool RenderWorker::advance(const UploadJob& job) {
  check_device();
  GpuVolume& volume = *volumes_.use(job.volume);
  const auto until = Clock::now() + kUploadTurn;
  while (!volume.is_complete() && Clock::now() < until) {
    throw_if_cancelled(job.stop);
    volume.upload_slab();
    if (job.progress) job.progress(LoadStage::upload, volume.uploaded());
  }
  return volume.is_complete();
}

}  // namespace cutaway
