// A few threads that do what is posted to them, in its order.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cutaway {

/// Chosen: our own, for Boost 1.74's thread_pool waits for ever in its constructor where the second
/// of its threads cannot be started.
class WorkerPool {
 public:
  /// Throws Error where so many threads cannot be had.
  explicit WorkerPool(int threads);
  ~WorkerPool();  ///< drops what still waits; returns when what was begun has ended
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Any thread. What `work` throws is logged.
  void post(std::function<void()> work);
  /// Returns when all that was posted is done. The pool does nothing any more afterwards.
  void finish();
  /// Returns when what was begun has ended; the rest is dropped.
  void stop();

 private:
  void serve(const std::stop_token& stop);
  std::function<void()> next(const std::stop_token& stop);

  std::mutex mutex_;  ///< of what follows
  std::condition_variable_any changed_;
  std::deque<std::function<void()>> waiting_;
  bool finishing_ = false;

  std::vector<std::jthread> threads_;  ///< last: they use all the others
};

}  // namespace cutaway
