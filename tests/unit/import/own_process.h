// What work takes of memory, measured where nothing else was done: a process' high-water mark never
// falls, and hides whatever is less than what came before.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <type_traits>

namespace cutaway::test {

/// `who`: RUSAGE_SELF or RUSAGE_CHILDREN.
inline std::int64_t peak_bytes(int who) {
  rusage usage{};
  getrusage(who, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

/// What `work` returns in a process of its own, which begins with what this one holds at the moment
/// and ends with the work. Expectations that fail in there are not seen here.
template <typename Work>
auto in_own_process(const Work& work) {
  using Result = std::invoke_result_t<Work>;
  static_assert(std::is_trivially_copyable_v<Result>);
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  const pid_t process = fork();
  if (process == 0) {
    // What it throws must not unwind into the tests of the process that it was copied from.
    const Result result = [&]() noexcept { return work(); }();
    _exit(::write(ends[1], &result, sizeof(result)) == ssize_t{sizeof(result)} ? 0 : 1);
  }
  close(ends[1]);
  Result result{};
  EXPECT_EQ(::read(ends[0], &result, sizeof(result)), ssize_t{sizeof(result)});
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_EQ(status, 0);
  return result;
}

}  // namespace cutaway::test
