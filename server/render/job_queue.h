// What waits to be drawn.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace cutaway {

/// One job at most waits for each view: the newest, in the place that the first one had. The queue
/// also keeps the releases of views: a job is taken together with every release that was asked for
/// before it, and with none that came after. Thread-safe. `Job` has a member `view`.
template <typename Job>
class JobQueue {
 public:
  struct Taken {
    std::vector<std::uint64_t> released;  ///< to be heeded first
    std::optional<Job> job;
  };

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

  /// Lets go of a view. Returns its waiting job, which will now not be served.
  std::optional<Job> release(std::uint64_t view) {
    const std::lock_guard lock(mutex_);
    released_.push_back(view);
    woken_ = true;
    changed_.notify_one();
    return withdraw(view);
  }

  /// The views released since they were last taken.
  std::vector<std::uint64_t> take_released() {
    const std::lock_guard lock(mutex_);
    return std::exchange(released_, {});
  }

  /// The view's waiting job, if it still waits.
  Taken take(std::uint64_t view) {
    const std::lock_guard lock(mutex_);
    return {std::exchange(released_, {}), withdraw(view)};
  }

  /// The jobs that wait, in the order in which they began to.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    const std::lock_guard lock(mutex_);
    for (const Job& job : jobs_) visit(job);
  }

  bool has(std::uint64_t view) const {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(jobs_, [=](const Job& job) { return job.view() == view; });
  }

  /// Waits until a job waits, or for a wake, a stop, or no longer than `most`. True where a job
  /// does.
  template <typename Duration>
  bool wait(const std::stop_token& stop, Duration most) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, most, [&] { return !jobs_.empty() || woken_; });
    woken_ = false;
    return !jobs_.empty();
  }

  /// The job that has waited longest.
  std::optional<Job> take() {
    const std::lock_guard lock(mutex_);
    if (jobs_.empty()) return std::nullopt;
    std::optional<Job> job(std::move(jobs_.front()));
    jobs_.pop_front();
    return job;
  }

  /// Ends one wait without a job.
  void wake() {
    const std::lock_guard lock(mutex_);
    woken_ = true;
    changed_.notify_one();
  }

 private:
  std::optional<Job> withdraw(std::uint64_t view) {
    for (auto at = jobs_.begin(); at != jobs_.end(); ++at) {
      if (at->view() != view) continue;
      std::optional<Job> job(std::move(*at));
      jobs_.erase(at);
      return job;
    }
    return std::nullopt;
  }

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  std::vector<std::uint64_t> released_;
  bool woken_ = false;
};

}  // namespace cutaway
