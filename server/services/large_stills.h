// Saved stills that take hundreds of megabytes until they are compressed: made one after the other.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "render/fair_share.h"
#include "render/render_thread.h"

namespace cutaway {

/// Sessions take turns: next is the one that has had the fewest pixels. Thread-safe.
class LargeStills {
 public:
  /// Called once, from a thread of its own that makes nothing else meanwhile, with the picture or
  /// with what ended it; or from the one that releases the view.
  using Done = std::function<void(RenderOutcome)>;

  /// What is asked of a RenderThread, in its words.
  struct Renderer {
    std::function<void(RenderJob)> submit;
    std::function<void(std::uint64_t view)> release;
  };

  /// `renderer` outlives it.
  explicit LargeStills(RenderThread& renderer);
  explicit LargeStills(Renderer renderer);
  /// Ends all as replaced.
  ~LargeStills();
  LargeStills(const LargeStills&) = delete;
  LargeStills& operator=(const LargeStills&) = delete;

  /// A view has one still here at most.
  void add(RenderRequest request, Done done);
  /// The view's still ends as replaced.
  void release(std::uint64_t view);

 private:
  struct Job {
    RenderRequest request;
    Done done;
  };

  void serve(const std::stop_token& stop);
  std::optional<Job> next(const std::stop_token& stop);
  Job take_next();
  RenderOutcome draw(const RenderRequest& request);
  RenderOutcome drawn(const RenderRequest& request);
  void give_up(std::uint64_t view);

  Renderer renderer_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> waiting_;
  FairShare turns_;
  std::optional<std::uint64_t> current_view_;
  bool given_up_ = false;  ///< the current one
  std::jthread thread_;
};

}  // namespace cutaway
