#include "services/large_stills.h"

#include <algorithm>
#include <exception>
#include <future>
#include <memory>
#include <utility>

#include "core/threads.h"
#include "render/render_error.h"

namespace cutaway {

namespace {

std::int64_t pixels_of(const RenderRequest& request) {
  const glm::ivec2 size_px = request.settings.picture_size_px;
  return std::int64_t{size_px.x} * size_px.y;
}

}  // namespace

LargeStills::LargeStills(RenderThread& renderer)
    : LargeStills({.submit = [&renderer](RenderJob job) { renderer.submit(std::move(job)); },
                   .release = [&renderer](std::uint64_t view) { renderer.release(view); }}) {}

LargeStills::LargeStills(Renderer renderer)
    : renderer_(std::move(renderer)),
      thread_(start_thread([this](const std::stop_token& stop) { serve(stop); })) {}

LargeStills::~LargeStills() {
  thread_.request_stop();
  {
    const std::lock_guard lock(mutex_);
    if (current_view_) give_up(*current_view_);
  }
  thread_.join();
  for (const Job& job : waiting_) job.done(RenderReplaced());
}

void LargeStills::add(RenderRequest request, Done done) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back({std::move(request), std::move(done)});
  changed_.notify_one();
}

void LargeStills::release(std::uint64_t view) {
  std::optional<Job> released;
  {
    const std::lock_guard lock(mutex_);
    turns_.forget(view);  // a session's share goes by the name of its first view
    if (current_view_ == view) give_up(view);
    const auto waiting =
        std::ranges::find_if(waiting_, [view](const Job& job) { return job.request.view == view; });
    if (waiting == waiting_.end()) return;
    released = std::move(*waiting);
    waiting_.erase(waiting);
  }
  released->done(RenderReplaced());
}

// The renderer has it, or is about to.
void LargeStills::give_up(std::uint64_t view) {
  given_up_ = true;
  renderer_.release(view);
}

void LargeStills::serve(const std::stop_token& stop) {
  while (const auto job = next(stop)) job->done(drawn(job->request));
}

std::optional<LargeStills::Job> LargeStills::next(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  current_view_.reset();
  given_up_ = false;
  if (!changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) || stop.stop_requested())
    return std::nullopt;
  Job job = take_next();
  current_view_ = job.request.view;
  return job;
}

LargeStills::Job LargeStills::take_next() {
  std::vector<std::uint64_t> shares;
  shares.reserve(waiting_.size());
  for (const Job& job : waiting_) shares.push_back(job.request.share);
  const std::uint64_t share = turns_.next(shares);
  const auto place = waiting_.begin() + (std::ranges::find(shares, share) - shares.begin());
  Job job = std::move(*place);
  waiting_.erase(place);
  turns_.charge(share, pixels_of(job.request));
  return job;
}

/// A failure is that still's own and ends neither the thread nor the others.
RenderOutcome LargeStills::drawn(const RenderRequest& request) {
  try {
    return draw(request);
  } catch (const std::exception& failure) {
    return render_error(failure, request.owner, request.view);
  }
}

RenderOutcome LargeStills::draw(const RenderRequest& request) {
  // Shared with the renderer, which may have it still where this ends early.
  const auto promise = std::make_shared<std::promise<RenderOutcome>>();
  auto outcome = promise->get_future();
  renderer_.submit(
      {request, [promise](RenderOutcome result) { promise->set_value(std::move(result)); }});
  {
    const std::lock_guard lock(mutex_);
    if (given_up_) renderer_.release(request.view);  // which came before the renderer had it
  }
  return outcome.get();
}

}  // namespace cutaway
