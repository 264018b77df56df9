#include "render/render_thread.h"

#include <future>

#include "render/render_worker.h"

namespace cutaway {

namespace {

void replace(std::optional<RenderJob> job) {
  if (job) job->done(RenderReplaced{});
}

}  // namespace

RenderThread::RenderThread(const gl::ContextOptions& options) {
  std::promise<RendererInfo> ready;
  auto info = ready.get_future();
  thread_ = std::jthread([this, options, &ready](const std::stop_token& stop) {
    std::unique_ptr<gl::Context> context;
    std::unique_ptr<RenderWorker> worker;
    try {
      context = gl::Context::create(options);
      worker = std::make_unique<RenderWorker>(*context);
    } catch (...) {
      ready.set_exception(std::current_exception());
      return;
    }
    ready.set_value({context->renderer(), context->version(), context->is_software()});
    serve(*worker, stop);
  });
  info_ = info.get();
}

RenderThread::~RenderThread() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  while (auto job = queue_.take()) replace(std::move(job));
}

void RenderThread::serve(RenderWorker& worker, const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    for (const std::uint64_t view : take_released()) worker.release(view);
    std::optional<RenderJob> job =
        worker.has_pending() ? queue_.take() : queue_.wait_and_take(stop);
    const bool idle = !job;
    if (job) worker.begin(std::move(*job));
    if (worker.is_lost()) lost_ = true;
    // With nothing else to draw there is time to wait for the pixels.
    worker.finish(idle);
  }
  while (worker.has_pending()) worker.finish(true);
}

void RenderThread::submit(RenderJob job) { replace(queue_.put(std::move(job))); }

bool RenderThread::renew(const RenderRequest& request) {
  return queue_.alter(request.view, [&](RenderJob& waiting) { waiting.request = request; });
}

void RenderThread::release(std::uint64_t view) {
  {
    const std::lock_guard lock(released_mutex_);
    released_.push_back(view);
  }
  replace(queue_.withdraw(view));
  queue_.wake();
}

std::vector<std::uint64_t> RenderThread::take_released() {
  const std::lock_guard lock(released_mutex_);
  return std::exchange(released_, {});
}

}  // namespace cutaway
