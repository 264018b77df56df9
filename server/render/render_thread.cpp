#include "render/render_thread.h"

#include <future>
#include <utility>

#include "core/machine_memory.h"
#include "core/threads.h"
#include "render/render_worker.h"

namespace cutaway {

namespace {

constexpr std::chrono::seconds kBetweenTidyings{10};

void replace(std::optional<RenderJob> job) {
  if (job) job->done(RenderReplaced{});
}

}  // namespace

RenderThread::RenderThread(const gl::ContextOptions& options, const RenderLimits& limits) {
  std::promise<RendererInfo> ready;
  auto info = ready.get_future();
  thread_ = start_thread([this, options, limits, &ready](const std::stop_token& stop) {
    std::unique_ptr<gl::Context> context;
    std::unique_ptr<RenderWorker> worker;
    RenderLimits in_force;
    try {
      context = gl::Context::create(options);
      in_force = limits_for(limits, context->is_software(), machine_memory_bytes());
      worker = std::make_unique<RenderWorker>(*context, in_force);
    } catch (...) {
      ready.set_exception(std::current_exception());
      return;
    }
    ready.set_value({context->renderer(), context->version(), context->is_software(),
                     context->max_3d_texture_size(), in_force});
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
    take_inbox(worker);
    if (worker.is_idle() && !queue_.wait(stop, kBetweenTidyings)) {
      worker.tidy();
      continue;
    }
    const bool drew = worker.draw_some(queue_);
    worker.upload_some();
    if (worker.is_lost()) lost_ = true;
    // With nothing else to do there is time to wait for the pixels.
    worker.finish(!drew && !worker.has_uploads());
  }
  worker.give_up();
}

void RenderThread::submit(RenderJob job) { replace(queue_.put(std::move(job))); }

bool RenderThread::renew(const RenderRequest& request) {
  return queue_.alter(request.view, [&](RenderJob& waiting) { waiting.request = request; });
}

void RenderThread::upload(std::shared_ptr<const LoadedVolume> volume, ProgressSink progress,
                          std::stop_token stop) {
  UploadJob job{std::move(volume), std::move(progress), std::move(stop), {}};
  std::future<void> done = job.done.get_future();
  {
    const std::lock_guard lock(inbox_mutex_);
    uploads_.push_back(std::move(job));
  }
  queue_.wake();
  try {
    done.get();
  } catch (const std::future_error&) {
    throw Cancelled();  // the thread has ended and the job went with it
  }
}

void RenderThread::release(std::uint64_t view) { replace(queue_.release(view)); }

void RenderThread::take_inbox(RenderWorker& worker) {
  worker.release(queue_.take_released());
  std::vector<UploadJob> uploads;
  {
    const std::lock_guard lock(inbox_mutex_);
    uploads = std::exchange(uploads_, {});
  }
  for (UploadJob& job : uploads) worker.add(std::move(job));
}

}  // namespace cutaway
