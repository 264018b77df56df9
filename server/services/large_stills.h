// Pictures too large to be drawn at once, made one after the other: each takes hundreds of
// megabytes until it is compressed.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "render/render_thread.h"

namespace cutaway {

/// Draws tile after tile, each a frame of its own among those of other views, so that a still for
/// print holds up nobody. Thread-safe.
class LargeStills {
 public:
  /// Called once, from a thread of its own that makes nothing else meanwhile, with the whole
  /// picture as RGBA or with what ended it; or from the one that releases the view.
  using Done = std::function<void(RenderOutcome)>;

  /// `renderer` outlives it.
  explicit LargeStills(RenderThread& renderer);
  /// Ends all as replaced; waits for a tile that is being drawn.
  ~LargeStills();
  LargeStills(const LargeStills&) = delete;
  LargeStills& operator=(const LargeStills&) = delete;

  /// `request` is of the whole picture; its view has one still here at most.
  void add(RenderRequest request, Done done);
  /// The view's still ends as replaced, at once or behind the tile that is being drawn.
  void release(std::uint64_t view);

 private:
  struct Job {
    RenderRequest request;
    Done done;
  };

  void serve(const std::stop_token& stop);
  std::optional<Job> next(const std::stop_token& stop);
  RenderOutcome make(const RenderRequest& request, const std::stop_token& stop);
  RenderOutcome draw(RenderRequest tile);
  bool is_given_up(const std::stop_token& stop);

  RenderThread& renderer_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> waiting_;
  std::optional<std::uint64_t> current_view_;
  bool given_up_ = false;  ///< the current one
  std::jthread thread_;
};

}  // namespace cutaway
