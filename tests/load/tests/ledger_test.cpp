#include "load/ledger.h"

#include <gtest/gtest.h>

namespace cutaway::load {
namespace {

constexpr std::size_t kBytes = 1000;

FrameHeader frame(std::uint32_t number, std::uint32_t input, double clock_ms, bool still = false) {
  return {.still = still, .number = number, .input = input, .clock_ms = clock_ms};
}

struct LedgerTest : testing::Test {
  Record record;
  Ledger ledger{record};
};

TEST_F(LedgerTest, LatencyIsTheAgeOfTheNewestInputShown) {
  ledger.arrived(frame(1, 3, 100.0), kBytes, 0.150);
  ASSERT_TRUE(record.frames[0].latency_ms);
  EXPECT_FLOAT_EQ(*record.frames[0].latency_ms, 50.0F);
}

TEST_F(LedgerTest, OnlyNewInputsAndMovingFramesHaveALatency) {
  ledger.arrived(frame(1, 3, 100.0), kBytes, 0.150);
  ledger.arrived(frame(2, 3, 100.0), kBytes, 0.200);
  ledger.arrived(frame(3, 4, 210.0, true), kBytes, 0.500);
  EXPECT_FALSE(record.frames[1].latency_ms);
  EXPECT_FALSE(record.frames[2].latency_ms);
}

TEST_F(LedgerTest, FramesThatGoBackAreStale) {
  ledger.arrived(frame(5, 10, 0), kBytes, 0.1);
  ledger.arrived(frame(7, 10, 0), kBytes, 0.2);  // one may be missing
  EXPECT_EQ(record.stale_frames, 0U);
  ledger.arrived(frame(7, 11, 0), kBytes, 0.3);
  EXPECT_EQ(record.stale_frames, 1U);
  ledger.arrived(frame(8, 10, 0), kBytes, 0.4);
  EXPECT_EQ(record.stale_frames, 2U);
}

TEST_F(LedgerTest, NumbersWrapAround) {
  ledger.arrived(frame(0xffffffffU, 0xffffffffU, 0), kBytes, 0.1);
  ledger.arrived(frame(0, 0, 0), kBytes, 0.2);
  EXPECT_EQ(record.stale_frames, 0U);
  EXPECT_TRUE(record.frames[1].latency_ms);
}

TEST_F(LedgerTest, TheStillOfTheLastInputIsTimed) {
  ledger.moved(1.0, 0.3);
  ledger.rested(9, 1.0);
  ledger.arrived(frame(1, 8, 0, true), kBytes, 1.1);  // of an earlier input
  ledger.arrived(frame(2, 9, 0), kBytes, 1.2);        // not refined
  ledger.arrived(frame(3, 9, 0, true), kBytes, 1.5);
  ledger.arrived(frame(4, 9, 0, true), kBytes, 1.9);
  ASSERT_EQ(record.stills.size(), 1U);
  EXPECT_DOUBLE_EQ(record.stills[0].after_s, 0.5);
}

TEST_F(LedgerTest, AMovementBeforeTheStillMakesItVoid) {
  ledger.rested(9, 1.0);
  ledger.moved(1.2, 0.3);
  ledger.arrived(frame(1, 9, 0, true), kBytes, 1.5);
  EXPECT_TRUE(record.stills.empty());
}

TEST_F(LedgerTest, MovementsAreApartByPauses) {
  for (const double at_s : {1.0, 1.2, 1.4, 3.0, 3.1}) ledger.moved(at_s, 0.3);
  ASSERT_EQ(record.moving.size(), 2U);
  EXPECT_DOUBLE_EQ(record.moving[0].end_s - record.moving[0].begin_s, 0.4);
  EXPECT_DOUBLE_EQ(record.moving[1].begin_s, 3.0);
}

TEST_F(LedgerTest, FramesKnowWhetherTheyCameWhileMoving) {
  ledger.moved(1.0, 0.3);
  ledger.arrived(frame(1, 1, 0), kBytes, 1.1);
  ledger.rested(1, 1.2);
  ledger.arrived(frame(2, 1, 0), kBytes, 1.3);
  EXPECT_TRUE(record.frames[0].moving);
  EXPECT_FALSE(record.frames[1].moving);
  EXPECT_EQ(record.first_frame_s, 1.1);
}

}  // namespace
}  // namespace cutaway::load
