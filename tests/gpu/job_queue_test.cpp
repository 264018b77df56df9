#include "render/job_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace cutaway {
namespace {

struct TestJob {
  std::uint64_t asked_by;
  int number;
  std::uint64_t view() const { return asked_by; }
};

TEST(JobQueue, TheNewestOfAViewTakesTheOldOnesPlace) {
  JobQueue<TestJob> queue;
  EXPECT_FALSE(queue.put({1, 10}));
  EXPECT_FALSE(queue.put({2, 20}));
  const auto replaced = queue.put({1, 11});
  ASSERT_TRUE(replaced);
  EXPECT_EQ(replaced->number, 10);
  EXPECT_EQ(queue.take()->number, 11);
  EXPECT_EQ(queue.take()->number, 20);
  EXPECT_FALSE(queue.take());
}

TEST(JobQueue, TellsWhoWaitsInTheirOrder) {
  JobQueue<TestJob> queue;
  queue.put({2, 0});
  queue.put({1, 0});
  queue.put({2, 1});
  std::vector<std::uint64_t> waiting;
  queue.for_each([&](const auto& job) { waiting.push_back(job.view()); });
  EXPECT_EQ(waiting, (std::vector<std::uint64_t>{2, 1}));
  EXPECT_TRUE(queue.has(1));
  EXPECT_FALSE(queue.has(3));
}

TEST(JobQueue, AltersAndGivesBackOnlyWhatWaits) {
  JobQueue<TestJob> queue;
  EXPECT_FALSE(queue.alter(1, [](TestJob&) { FAIL(); }));
  queue.put({1, 10});
  EXPECT_TRUE(queue.alter(1, [](TestJob& job) { job.number = 12; }));
  EXPECT_EQ(queue.take(1).job->number, 12);
  EXPECT_FALSE(queue.take(1).job);
  EXPECT_FALSE(queue.release(1));
}

TEST(JobQueue, AJobComesWithTheReleasesBeforeItAndNoneAfterIt) {
  using ViewOrder = std::vector<std::uint64_t>;
  JobQueue<TestJob> queue;
  queue.release(1);
  queue.put({1, 10});
  const auto taken = queue.take(1);
  EXPECT_EQ(taken.released, ViewOrder{1});
  EXPECT_EQ(taken.job->number, 10);
  EXPECT_EQ(queue.take_released(), ViewOrder{});

  queue.put({1, 11});
  EXPECT_EQ(queue.release(1)->number, 11);
  EXPECT_FALSE(queue.has(1));
  EXPECT_EQ(queue.take_released(), ViewOrder{1});
}

TEST(JobQueue, WaitingEndsWithAJobAWakeAStopOrItsTime) {
  using std::chrono::hours;
  JobQueue<TestJob> queue;
  std::jthread waiter([&](const std::stop_token& stop) {
    EXPECT_TRUE(queue.wait(stop, hours(1)));
    EXPECT_EQ(queue.take()->number, 5);
    EXPECT_FALSE(queue.wait(stop, hours(1)));  // woken
    EXPECT_FALSE(queue.wait(stop, hours(1)));  // stopped
  });
  queue.put({1, 5});
  queue.wake();
  waiter.request_stop();
  waiter.join();
  EXPECT_FALSE(queue.wait({}, std::chrono::milliseconds(1)));
}

}  // namespace
}  // namespace cutaway
