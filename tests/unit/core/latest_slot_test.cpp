#include "core/latest_slot.h"

#include <gtest/gtest.h>

#include <thread>

namespace cutaway {
namespace {

TEST(LatestSlot, GivesTheNewestAndReturnsTheReplaced) {
  LatestSlot<int> slot;
  EXPECT_EQ(slot.put(1), std::nullopt);
  EXPECT_EQ(slot.put(2), 1);
  EXPECT_EQ(slot.take(), 2);
  EXPECT_EQ(slot.take(), std::nullopt);
}

TEST(LatestSlot, LosesNothingBetweenThreads) {
  constexpr int kValues = 20000;
  LatestSlot<int> slot;
  int seen = 0;
  int replaced = 0;
  {
    const std::jthread writer([&] {
      for (int i = 0; i < kValues; ++i) replaced += slot.put(i).has_value() ? 1 : 0;
    });
    for (int i = 0; i < kValues; ++i) seen += slot.take().has_value() ? 1 : 0;
  }
  while (slot.take()) ++seen;
  EXPECT_EQ(seen + replaced, kValues);
}

}  // namespace
}  // namespace cutaway
