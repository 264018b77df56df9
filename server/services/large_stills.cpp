#include "services/large_stills.h"

#include <algorithm>
#include <future>
#include <limits>
#include <new>
#include <utility>

#include "core/threads.h"
#include "services/picture_tiles.h"

namespace cutaway {

namespace {

std::uint32_t limited(std::uint64_t microseconds) {
  constexpr std::uint64_t kLongest = std::numeric_limits<std::uint32_t>::max();
  return static_cast<std::uint32_t>(std::min(microseconds, kLongest));
}

Error no_memory() {
  return Error({.code = "too-large",
                .message = "there is not enough memory for a still of this size",
                .field = "/width_px"});
}

}  // namespace

LargeStills::LargeStills(RenderThread& renderer)
    : renderer_(renderer),
      thread_(start_thread([this](const std::stop_token& stop) { serve(stop); })) {}

LargeStills::~LargeStills() {
  thread_.request_stop();
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
    given_up_ = given_up_ || current_view_ == view;
    const auto waiting =
        std::ranges::find_if(waiting_, [view](const Job& job) { return job.request.view == view; });
    if (waiting == waiting_.end()) return;
    released = std::move(*waiting);
    waiting_.erase(waiting);
  }
  released->done(RenderReplaced());
}

void LargeStills::serve(const std::stop_token& stop) {
  while (const auto job = next(stop)) {
    RenderOutcome outcome = RenderReplaced();
    try {
      outcome = make(job->request, stop);
    } catch (const std::bad_alloc&) {
      outcome = no_memory();
    }
    job->done(std::move(outcome));
  }
}

std::optional<LargeStills::Job> LargeStills::next(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  current_view_.reset();
  given_up_ = false;
  if (!changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) || stop.stop_requested())
    return std::nullopt;
  Job job = std::move(waiting_.front());
  waiting_.pop_front();
  current_view_ = job.request.view;
  return job;
}

RenderOutcome LargeStills::make(const RenderRequest& request, const std::stop_token& stop) {
  PictureTiles tiles(request);
  RenderedFrame whole{.label = request.label};
  std::uint64_t render_us = 0;
  for (int index = 0; index < tiles.count(); ++index) {
    RenderOutcome outcome = draw(tiles.request(index));
    if (is_given_up(stop)) {
      renderer_.release(request.view);  // which this tile may have made anew
      return RenderReplaced();
    }
    const auto* tile = std::get_if<RenderedFrame>(&outcome);
    if (tile == nullptr) return outcome;
    tiles.take(index, tile->pixels);
    render_us += tile->render_us;
    whole.cast_rays = tile->cast_rays;
  }
  whole.pixels = tiles.picture();
  whole.render_us = limited(render_us);
  return whole;
}

RenderOutcome LargeStills::draw(RenderRequest tile) {
  std::promise<RenderOutcome> promise;
  auto outcome = promise.get_future();
  renderer_.submit({std::move(tile),
                    [&promise](RenderOutcome result) { promise.set_value(std::move(result)); }});
  return outcome.get();
}

bool LargeStills::is_given_up(const std::stop_token& stop) {
  const std::lock_guard lock(mutex_);
  return given_up_ || stop.stop_requested();
}

}  // namespace cutaway
