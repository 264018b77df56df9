#include "core/worker_pool.h"

#include <exception>
#include <utility>

#include "core/log.h"
#include "core/threads.h"

namespace cutaway {

WorkerPool::WorkerPool(int threads) {
  for (int i = 0; i < threads; ++i) {
    threads_.push_back(start_thread([this](const std::stop_token& stop) { serve(stop); }));
  }
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::post(std::function<void()> work) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(work));
  changed_.notify_one();
}

void WorkerPool::finish() {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
    changed_.notify_all();
  }
  for (auto& thread : threads_) thread.join();
  threads_.clear();
}

void WorkerPool::stop() {
  for (auto& thread : threads_) thread.request_stop();
  threads_.clear();
  const auto dropped = std::exchange(waiting_, {});
}

void WorkerPool::serve(const std::stop_token& stop) {
  while (const auto work = next(stop)) {
    try {
      work();
    } catch (const std::exception& failure) {
      log().error("a piece of work failed: {}", failure.what());
    }
  }
}

// A piece of work may post another: it is done as well while the pool finishes.
std::function<void()> WorkerPool::next(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, stop, [this] { return finishing_ || !waiting_.empty(); });
  if (stop.stop_requested() || waiting_.empty()) return nullptr;
  auto work = std::move(waiting_.front());
  waiting_.pop_front();
  return work;
}

}  // namespace cutaway
