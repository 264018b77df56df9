#include "core/threads.h"

#include <sys/resource.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"

namespace cutaway {

namespace {

std::string threads_of_user() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NPROC, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return "unlimited";
  return std::to_string(limit.rlim_cur);
}

Error no_more_threads(const std::system_error& refusal) {
  return Error({.code = ErrorCode::internal,
                .message = "no more threads can be started",
                .field = {},
                .expected = "a larger limit of processes for this user (ulimit -u, now " +
                            threads_of_user() + ") or container (pids.max, TasksMax)",
                .received = refusal.code().message()});
}

}  // namespace

std::jthread start_thread(std::function<void(const std::stop_token&)> work) try {
  return std::jthread(std::move(work));
} catch (const std::system_error& refusal) {
  throw no_more_threads(refusal);
}

void require_threads(int count) {
  std::vector<std::jthread> idle;
  idle.reserve(static_cast<std::size_t>(count));
  const auto until_stopped = [](const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait(lock, stop, [] { return false; });
  };
  for (int i = 0; i < count; ++i) idle.push_back(start_thread(until_stopped));
  for (auto& thread : idle) thread.request_stop();
}

}  // namespace cutaway
