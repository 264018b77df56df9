#include "render/render_worker.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/log.h"
#include "render/render_error.h"

namespace cutaway {

namespace {

/// Frames whose pixels are on their way while the next are drawn.
constexpr std::size_t kReadbacksInFlight = 3;
constexpr std::size_t kStepsInFlight = 2;
constexpr std::size_t kKeptReadbackBytes = std::size_t{16} << 20;
constexpr std::chrono::seconds kIdleViews{60};
/// Of an upload between two frames.
constexpr std::chrono::milliseconds kUploadTurn{10};

std::uint32_t microseconds(std::chrono::microseconds spent) {
  constexpr std::int64_t kLongest = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min<std::int64_t>(spent.count(), kLongest));
}

/// What the receiver throws is its own failure and ends nobody else's frames.
void hand_over(const RenderJob& job, RenderOutcome outcome) {
  try {
    job.done(std::move(outcome));
  } catch (const std::exception& failure) {
    log().error("{}: a frame of view {} was not taken: {}", job.request.owner, job.view(),
                failure.what());
  }
}

}  // namespace

RenderWorker::RenderWorker(const gl::Context& context, const RenderLimits& limits)
    : context_(context),
      step_cost_(limits.step),
      view_bytes_(limits.view_bytes),
      views_(limits.view_bytes),
      volumes_(context.max_3d_texture_size(), limits.volume_bytes) {}

bool RenderWorker::draw_some(JobQueue<RenderJob>& queue) {
  const std::vector<ShareOfView> waiting = views_that_wait(queue);
  if (waiting.empty()) return false;
  const std::uint64_t view = turns_.next(waiting);
  Place drawing = find(view);
  if (drawing != drawing_.end() && drawing->request().yields && queue.has(view)) {
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
std::vector<ShareOfView> RenderWorker::views_that_wait(const JobQueue<RenderJob>& queue) const {
  std::vector<ShareOfView> views;
  for (const Drawing& drawing : drawing_) views.push_back(drawing.who());
  if (!drawing_.empty() && !views_.has_room()) return views;
  queue.for_each([&views](const RenderJob& job) {
    if (std::ranges::find(views, job.view(), &ShareOfView::view) == views.end())
      views.push_back({job.view(), job.request.share});
  });
  return views;
}

RenderWorker::Place RenderWorker::find(std::uint64_t view) {
  return std::ranges::find_if(drawing_, [=](const Drawing& each) { return each.view() == view; });
}

// With all that is drawn beside it a part stays within the views' memory (ViewCache::has_room). One
// whose buffers serve nothing after it leaves more of them to those that do.
PartLimits RenderWorker::part_limits(bool is_followed) const {
  return {.bytes = view_bytes_ / (is_followed ? 2 : 4), .side_px = context_.max_texture_size()};
}

/// False where it has failed.
bool RenderWorker::begin(RenderJob job) {
  auto commission = std::make_shared<Commission>(std::move(job), Clock::now());
  const RenderRequest& request = commission->job.request;
  views_.pin(request.view);
  try {
    check_device();
    commission->parts =
        PictureParts(*request.scene, request.settings, part_limits(request.is_followed));
    volumes_.show(request.view, request.volume);
    Drawing drawing{commission, volumes_.use(request.volume), {}};
    drawing.volume->upload_rest();
    plan_part(drawing);
    drawing_.push_back(std::move(drawing));
    return true;
  } catch (const std::exception& failure) {
    views_.unpin(request.view);
    conclude(*commission, render_error(failure, request.owner, request.view));
    return false;
  }
}

void RenderWorker::plan_part(Drawing& drawing) {
  Commission& commission = *drawing.commission;
  const RenderRequest& request = commission.job.request;
  drawing.plan = pipeline_.plan(views_.pinned(request.view), *request.scene, *drawing.volume,
                                commission.parts.settings(drawing.part));
  commission.cast_rays = commission.cast_rays || drawing.plan.has(kRayCast);
  views_.keep_within_limit();
}

void RenderWorker::step(Place drawing) {
  const Commission& commission = *drawing->commission;
  try {
    check_device();
    if (!commission.is_ended) turns_.charge(drawing->who(), drawing->plan.advance(step_cost_));
    keep_pace();
    if (!commission.is_ended && !drawing->plan.is_done()) return;
    if (!commission.is_ended) read_back(*drawing);
    // A part before it may have failed on its way.
    const bool goes_on = !commission.is_ended && ++drawing->part < commission.parts.count();
    if (goes_on) return plan_part(*drawing);
  } catch (const std::exception& failure) {
    return end(drawing, render_error(failure, drawing->request().owner, drawing->view()));
  }
  views_.unpin(drawing->view());
  drawing_.erase(drawing);
}

// The device may have a step or two ahead of it, or it would run dry, and no more, or a small frame
// would wait behind all that was asked for before it.
void RenderWorker::keep_pace() {
  steps_.push_back(gl::Fence::insert());
  if (steps_.size() <= kStepsInFlight) return;
  steps_.front().wait();
  steps_.pop_front();
}

void RenderWorker::read_back(const Drawing& drawing) {
  if (pending_.size() >= kReadbacksInFlight) finish(true);
  gl::PixelReadback readback;
  if (!idle_readbacks_.empty()) {
    readback = std::move(idle_readbacks_.back());
    idle_readbacks_.pop_back();
  }
  const RenderRequest& request = drawing.request();
  FramePipeline::start_readback(views_.pinned(request.view), request.settings.layout, readback);
  pending_.push_back({drawing.commission, drawing.part, std::move(readback)});
}

void RenderWorker::end(Place drawing, RenderOutcome outcome) {
  const std::shared_ptr<Commission> commission = drawing->commission;
  views_.unpin(drawing->view());
  drawing_.erase(drawing);
  conclude(*commission, std::move(outcome));
}

// Once: what comes after it has no receiver any more.
void RenderWorker::conclude(Commission& commission, RenderOutcome outcome) {
  if (!std::exchange(commission.is_ended, true)) hand_over(commission.job, std::move(outcome));
}

void RenderWorker::release(std::span<const std::uint64_t> views) {
  for (const std::uint64_t view : views) release(view);
}

void RenderWorker::release(std::uint64_t view) {
  if (const Place drawing = find(view); drawing != drawing_.end()) end(drawing, RenderReplaced{});
  views_.drop(view);
  volumes_.forget(view);
  turns_.forget(view);
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
  if (lost_)
    throw Error({.code = ErrorCode::render_failed, .message = "the graphics device was lost"});
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
  Commission& commission = *pending.commission;
  try {
    std::vector<PixelPlane> planes = pending.readback.finish();
    keep(std::move(pending.readback));
    if (commission.is_ended) return;
    const RenderSettings drawn = commission.parts.settings(pending.part);
    commission.parts.take(pending.part, {drawn.layout, drawn.picture_size_px, std::move(planes)});
    if (commission.parts.is_whole()) conclude(commission, frame_of(commission));
  } catch (const std::exception& failure) {
    conclude(commission,
             render_error(failure, commission.job.request.owner, commission.job.view()));
  }
}

RenderedFrame RenderWorker::frame_of(Commission& commission) {
  const auto spent =
      std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - commission.begun);
  return {.picture = commission.parts.whole(),
          .render_us = microseconds(spent),
          .cast_rays = commission.cast_rays,
          .label = commission.job.request.label};
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
