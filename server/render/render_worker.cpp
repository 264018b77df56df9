#include "render/render_worker.h"

#include "core/log.h"

namespace cutaway {

namespace {

/// Frames whose pixels are on their way while the next are drawn.
constexpr std::size_t kReadbacksInFlight = 3;

Pixels pixels_of(const RenderSettings& settings, gl::PixelReadback& readback) {
  return {settings.layout, settings.picture_size_px, readback.finish()};
}

}  // namespace

void RenderWorker::begin(RenderJob job) {
  drop_unused_volumes();
  gl::PixelReadback readback;
  if (!idle_readbacks_.empty()) {
    readback = std::move(idle_readbacks_.back());
    idle_readbacks_.pop_back();
  }
  Pending pending{std::move(job), std::move(readback), Clock::now()};
  try {
    draw(pending);
  } catch (const Error& error) {
    pending.job.done(error);
    return;
  } catch (const std::exception& failure) {
    log().error("view {} could not be drawn: {}", pending.job.view(), failure.what());
    pending.job.done(Error({.code = "render-failed", .message = "the picture could not be drawn"}));
    return;
  }
  pending_.push_back(std::move(pending));
  if (pending_.size() >= kReadbacksInFlight) finish(true);
}

void RenderWorker::draw(Pending& pending) {
  const RenderRequest& request = pending.job.request;
  lost_ = lost_ || context_.is_lost();  // the device tells of it once
  if (lost_) throw Error({.code = "render-failed", .message = "the graphics device was lost"});
  ViewState& view = views_[request.view];
  pipeline_.render(view, *request.scene, volume_for(request.volume), request.settings);
  FramePipeline::start_readback(view, request.settings.layout, pending.readback);
}

void RenderWorker::finish(bool wait) {
  while (!pending_.empty() && (wait || pending_.front().readback.is_ready())) {
    wait = false;
    Pending pending = std::move(pending_.front());
    pending_.pop_front();
    deliver(pending);
    idle_readbacks_.push_back(std::move(pending.readback));
  }
}

void RenderWorker::deliver(Pending& pending) {
  const RenderRequest& request = pending.job.request;
  RenderedFrame frame{.pixels = pixels_of(request.settings, pending.readback),
                      .label = request.label};
  const auto spent =
      std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - pending.begun);
  frame.render_us = static_cast<std::uint32_t>(spent.count());
  pending.job.done(std::move(frame));
}

GpuVolume& RenderWorker::volume_for(const std::shared_ptr<const LoadedVolume>& loaded) {
  const auto known = volumes_.find(loaded);
  if (known != volumes_.end()) return known->second;
  return volumes_.emplace(loaded, GpuVolume(loaded, context_.max_3d_texture_size(), {}))
      .first->second;
}

void RenderWorker::drop_unused_volumes() {
  // Two owners are left when nobody else wants a volume: the map's key and the GpuVolume itself.
  std::erase_if(volumes_, [](const auto& entry) { return entry.first.use_count() <= 2; });
}

}  // namespace cutaway
