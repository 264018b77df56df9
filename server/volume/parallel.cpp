#include "volume/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "core/progress.h"

namespace cutaway {

namespace {

class Run {
 public:
  Run(const ParallelLoop& loop, const std::stop_token& stop) : loop_(loop), stop_(stop) {}

  void work(bool report) {
    for (int i = next_++; i < loop_.count && !given_up(); i = next_++) {
      do_turn(i);
      const int done = ++done_;
      if (report && loop_.progress) loop_.progress(double(done) / loop_.count);
    }
  }

  void finish() const {
    if (failure_) std::rethrow_exception(failure_);
    throw_if_cancelled(stop_);
    if (loop_.progress) loop_.progress(1.0);
  }

 private:
  bool given_up() const { return failed_ || stop_.stop_requested(); }

  void do_turn(int i) {
    try {
      loop_.turn(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  const ParallelLoop& loop_;
  const std::stop_token& stop_;
  std::atomic<int> next_ = 0;
  std::atomic<int> done_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

int default_thread_count() { return int(std::max(1u, std::thread::hardware_concurrency())); }

void run_parallel(const ParallelLoop& loop, const std::stop_token& stop) {
  Run run(loop, stop);
  {
    std::vector<std::jthread> helpers;
    const int helper_count = std::min(loop.threads, loop.count) - 1;
    helpers.reserve(std::max(helper_count, 0));
    try {
      for (int i = 0; i < helper_count; ++i) helpers.emplace_back([&run] { run.work(false); });
    } catch (const std::system_error&) {  // no more threads to be had: those that there are do it
    }
    run.work(true);
  }
  run.finish();
}

}  // namespace cutaway
