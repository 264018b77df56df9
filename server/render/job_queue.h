// Which view is drawn next.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

namespace cutaway {

/// At most one waiting job a view; views are served in the order in which they began to wait, so
/// that no view that asks often starves one that asks seldom. Thread-safe. `Job` has a member
/// `view`.
template <typename Job>
class JobQueue {
 public:
  /// Returns the view's job that was waiting and whose place the new one takes, if there was one.
  std::optional<Job> put(Job job) {
    const std::lock_guard lock(mutex_);
    for (Job& waiting : jobs_) {
      if (waiting.view() == job.view()) return std::exchange(waiting, std::move(job));
    }
    jobs_.push_back(std::move(job));
    changed_.notify_one();
    return std::nullopt;
  }

  /// Lets `change` alter the view's waiting job, which keeps its place. False where none waits.
  template <typename Change>
  bool alter(std::uint64_t view, Change&& change) {
    const std::lock_guard lock(mutex_);
    for (Job& waiting : jobs_) {
      if (waiting.view() != view) continue;
      std::forward<Change>(change)(waiting);
      return true;
    }
    return false;
  }

  /// The view's waiting job, which will now not be served.
  std::optional<Job> withdraw(std::uint64_t view) {
    const std::lock_guard lock(mutex_);
    for (auto at = jobs_.begin(); at != jobs_.end(); ++at) {
      if (at->view() != view) continue;
      std::optional<Job> job(std::move(*at));
      jobs_.erase(at);
      return job;
    }
    return std::nullopt;
  }

  /// Waits for a job; nothing when told to stop.
  std::optional<Job> wait_and_take(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [&] { return !jobs_.empty() || woken_; });
    woken_ = false;
    return take_locked();
  }

  std::optional<Job> take() {
    const std::lock_guard lock(mutex_);
    return take_locked();
  }

  /// Ends one wait without a job.
  void wake() {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    changed_.notify_one();
  }

 private:
  std::optional<Job> take_locked() {
    if (jobs_.empty()) return std::nullopt;
    std::optional<Job> job(std::move(jobs_.front()));
    jobs_.pop_front();
    return job;
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  bool woken_ = false;
};

}  // namespace cutaway
