#include "core/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

namespace cutaway {
namespace {

TEST(WorkerPool, DoesAllThatWasPostedBeforeItFinishes) {
  std::atomic<int> done = 0;
  WorkerPool pool(3);
  for (int i = 0; i < 100; ++i) pool.post([&] { ++done; });
  pool.post([&] { pool.post([&] { ++done; }); });
  pool.finish();
  EXPECT_EQ(done, 101);
}

TEST(WorkerPool, OneThreadKeepsTheOrder) {
  std::string order;
  WorkerPool pool(1);
  for (const char letter : {'a', 'b', 'c'}) pool.post([&order, letter] { order += letter; });
  pool.finish();
  EXPECT_EQ(order, "abc");
}

TEST(WorkerPool, WhatFailsEndsNothingElse) {
  bool done = false;
  WorkerPool pool(1);
  pool.post([] { throw std::runtime_error("once"); });
  pool.post([&] { done = true; });
  pool.finish();
  EXPECT_TRUE(done);
}

TEST(WorkerPool, StoppingWaitsForWhatWasBegunAndBeginsNothingMore) {
  std::promise<void> begun;
  std::promise<void> released;
  bool ended = false;
  bool begun_later = false;
  WorkerPool pool(1);
  pool.post([&] {
    begun.set_value();
    released.get_future().wait();
    ended = true;
  });
  begun.get_future().wait();
  std::jthread stopper([&pool] { pool.stop(); });
  released.set_value();
  stopper.join();
  EXPECT_TRUE(ended);
  pool.post([&] { begun_later = true; });
  pool.finish();
  EXPECT_FALSE(begun_later);
}

}  // namespace
}  // namespace cutaway
