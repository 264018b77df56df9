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

TEST(JobQueue, AViewThatAsksOftenDoesNotStarveTheOthers) {
  JobQueue<TestJob> queue;
  queue.put({1, 0});
  queue.put({2, 0});
  queue.put({3, 0});
  std::vector<std::uint64_t> order;
  for (int i = 0; i < 6; ++i) {
    order.push_back(queue.take()->view());
    queue.put({1, i});
    queue.put({order.back(), i});
  }
  EXPECT_EQ(order, (std::vector<std::uint64_t>{1, 2, 3, 1, 2, 3}));
}

TEST(JobQueue, AltersAndWithdrawsOnlyWhatWaits) {
  JobQueue<TestJob> queue;
  EXPECT_FALSE(queue.alter(1, [](TestJob&) { FAIL(); }));
  queue.put({1, 10});
  EXPECT_TRUE(queue.alter(1, [](TestJob& job) { job.number = 12; }));
  EXPECT_EQ(queue.withdraw(1)->number, 12);
  EXPECT_FALSE(queue.withdraw(1));
}

TEST(JobQueue, WaitingEndsWithAJobAWakeOrAStop) {
  JobQueue<TestJob> queue;
  std::jthread waiter([&](const std::stop_token& stop) {
    EXPECT_EQ(queue.wait_and_take(stop)->number, 5);
    EXPECT_FALSE(queue.wait_and_take(stop));  // woken
    EXPECT_FALSE(queue.wait_and_take(stop));  // stopped
  });
  queue.put({1, 5});
  queue.wake();
  waiter.request_stop();
}

}  // namespace
}  // namespace cutaway
