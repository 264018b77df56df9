#include "app/still_queue.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cutaway {

void StillQueue::add(RenderRequest request, std::weak_ptr<RenderThread> renderer,
                     TiledStill::Done done) {
  const std::uint64_t view = request.view;
  const auto ended = [this, done](RenderOutcome outcome) {
    done(std::move(outcome));
    {
      const std::lock_guard lock(mutex_);
      busy_ = false;
    }
    begin_next();
  };
  auto still = std::make_shared<TiledStill>(std::move(request), std::move(renderer), pool_, ended);
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({view, std::move(still), std::move(done)});
  }
  begin_next();
}

void StillQueue::begin_next() {
  std::shared_ptr<TiledStill> next;
  {
    const std::lock_guard lock(mutex_);
    if (busy_ || waiting_.empty()) return;
    busy_ = true;
    next = std::move(waiting_.front().still);
    waiting_.pop_front();
  }
  next->start();
}

void StillQueue::release(std::uint64_t view) {
  std::optional<TiledStill::Done> done;
  {
    const std::lock_guard lock(mutex_);
    const auto waiting = std::ranges::find(waiting_, view, &Waiting::view);
    if (waiting == waiting_.end()) return;
    done = std::move(waiting->done);
    waiting_.erase(waiting);
  }
  (*done)(RenderReplaced());
}

}  // namespace cutaway
