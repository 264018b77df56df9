// Large stills, one after the other: each takes hundreds of megabytes until it is compressed.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "app/tiled_still.h"

namespace cutaway {

/// Thread-safe.
class StillQueue {
 public:
  explicit StillQueue(boost::asio::thread_pool& pool) : pool_(pool) {}

  /// As TiledStill; `request`'s view has one still here at most.
  void add(RenderRequest request, std::weak_ptr<RenderThread> renderer, TiledStill::Done done);
  /// A still of the view that waits ends as replaced.
  void release(std::uint64_t view);

 private:
  struct Waiting {
    std::uint64_t view;
    std::shared_ptr<TiledStill> still;
    TiledStill::Done done;
  };

  void begin_next();

  boost::asio::thread_pool& pool_;
  std::mutex mutex_;
  bool busy_ = false;
  std::deque<Waiting> waiting_;
};

}  // namespace cutaway
