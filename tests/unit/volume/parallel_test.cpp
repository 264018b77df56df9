#include "volume/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/progress.h"

namespace cutaway {
namespace {

TEST(RunParallel, DoesEachTurnOnceWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> turns(1000);
    run_parallel(
        {.count = 1000, .turn = [&](int i) { ++turns[i]; }, .progress = {}, .threads = threads},
        {});
    for (const std::atomic<int>& count : turns) EXPECT_EQ(count, 1);
  }
}

TEST(RunParallel, ReportsRisingProgressFromTheCallingThread) {
  const std::thread::id caller = std::this_thread::get_id();
  double last = 0.0;
  run_parallel({.count = 500,
                .turn = [](int) {},
                .progress =
                    [&](double fraction) {
                      EXPECT_TRUE(std::this_thread::get_id() == caller);
                      EXPECT_GE(fraction, last);
                      last = fraction;
                    },
                .threads = 2},
               {});
  EXPECT_EQ(last, 1.0);
}

TEST(RunParallel, PassesOnWhatATurnThrows) {
  const auto turn = [](int i) {
    if (i == 5) throw std::runtime_error("five");
  };
  EXPECT_THROW(run_parallel({.count = 100, .turn = turn, .progress = {}, .threads = 2}, {}),
               std::runtime_error);
}

TEST(RunParallel, EndsEarlyWhenAskedToStop) {
  std::stop_source source;
  std::atomic<int> turns = 0;
  const auto turn = [&](int) {
    ++turns;
    source.request_stop();
  };
  EXPECT_THROW(run_parallel({.count = 100000, .turn = turn, .progress = {}, .threads = 2},
                            source.get_token()),
               Cancelled);
  EXPECT_LT(turns, 100);
}

TEST(RunParallel, NothingToDoIsDone) {
  run_parallel({.count = 0, .turn = [](int) { FAIL(); }, .progress = {}}, {});
}

}  // namespace
}  // namespace cutaway
