// One load and those who wait for it.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>

#include "session/volume_library.h"

namespace cutaway {

/// Someone who wants to hear of a load. Once dismissed it hears nothing more: dismiss waits for a
/// call that is under way.
class LoadWaiter {
 public:
  LoadWaiter(ProgressSink progress, std::function<void(OpenOutcome)> done)
      : progress_(std::move(progress)), done_(std::move(done)) {}

  void progress(LoadStage stage, double fraction) {
    const std::lock_guard lock(mutex_);
    if (progress_) progress_(stage, fraction);
  }
  void finish(OpenOutcome outcome) {
    const std::lock_guard lock(mutex_);
    if (done_) done_(std::move(outcome));
    dismiss_locked();
  }
  void dismiss() {
    const std::lock_guard lock(mutex_);
    dismiss_locked();
  }

 private:
  void dismiss_locked() {
    progress_ = nullptr;
    done_ = nullptr;
  }

  std::mutex mutex_;
  ProgressSink progress_;
  std::function<void(OpenOutcome)> done_;
};

/// Thread-safe.
class LoadJob {
 public:
  explicit LoadJob(std::string id) : id_(std::move(id)) {}

  const std::string& id() const { return id_; }
  std::stop_token stop() const { return stop_.get_token(); }

  /// True for the first who asks: a job may wait in two places.
  bool claim() { return !claimed_.exchange(true); }
  /// It was put by, and is to be begun again.
  void give_back() { claimed_ = false; }

  void join(const std::shared_ptr<LoadWaiter>& waiter) {
    const std::lock_guard lock(mutex_);
    waiters_.push_back(waiter);
  }
  /// True, and the load asked to stop, where nobody is left.
  bool leave(const std::shared_ptr<LoadWaiter>& waiter) {
    const std::lock_guard lock(mutex_);
    waiters_.remove(waiter);
    if (!waiters_.empty()) return false;
    stop_.request_stop();
    return true;
  }
  void progress(LoadStage stage, double fraction) {
    for (const auto& waiter : waiters()) waiter->progress(stage, fraction);
  }
  /// Nothing of it is kept: who hears of it last may let go of the volume and have its memory back.
  void finish(OpenOutcome outcome) {
    std::list<std::shared_ptr<LoadWaiter>> waiters;
    {
      const std::lock_guard lock(mutex_);
      waiters.swap(waiters_);
    }
    while (waiters.size() > 1) {
      waiters.front()->finish(outcome);
      waiters.pop_front();
    }
    if (!waiters.empty()) waiters.front()->finish(std::move(outcome));
  }

 private:
  std::list<std::shared_ptr<LoadWaiter>> waiters() {
    const std::lock_guard lock(mutex_);
    return waiters_;
  }

  std::string id_;
  std::atomic<bool> claimed_ = false;
  std::stop_source stop_;
  std::mutex mutex_;
  std::list<std::shared_ptr<LoadWaiter>> waiters_;
};

}  // namespace cutaway
