// Credits, rate limit and pacer: the small rules of flow control.
#include <gtest/gtest.h>

#include "session/credits.h"
#include "session/pacer.h"
#include "session/token_bucket.h"

namespace cutaway {
namespace {

using std::chrono::milliseconds;

const TimePoint kStart{std::chrono::hours(1)};

TEST(Credits, AreTakenUntilNoneIsLeftAndComeBack) {
  Credits credits(2);
  EXPECT_TRUE(credits.take());
  EXPECT_TRUE(credits.take());
  EXPECT_FALSE(credits.take());
  credits.give_back();
  EXPECT_EQ(credits.free(), 1);
  EXPECT_TRUE(credits.take());
}

TEST(CreditsDeath, CannotBeReturnedTwice) {
  Credits credits(1);
  EXPECT_DEATH(credits.give_back(), "a credit is returned once");
}

TEST(TokenBucket, AllowsABurstThenTheRate) {
  TokenBucket bucket({.per_second = 10.0, .burst = 3.0}, kStart);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(bucket.take(kStart));
  EXPECT_FALSE(bucket.take(kStart));
  EXPECT_FALSE(bucket.take(kStart + milliseconds(99)));
  EXPECT_TRUE(bucket.take(kStart + milliseconds(101)));
  EXPECT_FALSE(bucket.take(kStart + milliseconds(101)));
}

TEST(TokenBucket, SavesNoMoreThanTheBurst) {
  TokenBucket bucket({.per_second = 10.0, .burst = 3.0}, kStart);
  const TimePoint later = kStart + std::chrono::hours(1);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(bucket.take(later));
  EXPECT_FALSE(bucket.take(later));
}

TEST(TokenBucket, IsPaidBackWhereItWasCharged) {
  TokenBucket bucket({.per_second = 10.0, .burst = 3.0}, kStart);
  bucket.charge(kStart, 5.0);
  EXPECT_FALSE(bucket.take(kStart + milliseconds(250)));
  EXPECT_TRUE(bucket.take(kStart + milliseconds(301)));
}

TEST(TokenBucket, LeavesWhatIsToBeLeft) {
  TokenBucket bucket({.per_second = 10.0, .burst = 4.0}, kStart);
  bucket.charge_above(kStart, 100.0, 2.0);
  EXPECT_TRUE(bucket.take(kStart));
  bucket.charge_above(kStart, 100.0, 2.0);  // there is less already, which stays
  EXPECT_TRUE(bucket.take(kStart));
  EXPECT_FALSE(bucket.take(kStart));
}

class PacerTest : public ::testing::Test {
 protected:
  Pacer pacer{Milliseconds(200.0)};
  TimePoint now = kStart;
};

TEST_F(PacerTest, OwesNothingBeforeAnythingChanged) {
  EXPECT_EQ(pacer.due(now), std::nullopt);
  EXPECT_EQ(pacer.next_due(now), std::nullopt);
}

TEST_F(PacerTest, OwesAnInteractiveFrameAtOnceAndAStillOneAfterRest) {
  pacer.changed(now);
  EXPECT_EQ(pacer.due(now), FrameKind::interactive);
  pacer.asked(FrameKind::interactive, now);
  EXPECT_EQ(pacer.due(now), std::nullopt);
  EXPECT_EQ(pacer.next_due(now), now + milliseconds(200));
  EXPECT_EQ(pacer.due(now + milliseconds(199)), std::nullopt);
  EXPECT_EQ(pacer.due(now + milliseconds(200)), FrameKind::still);
}

TEST_F(PacerTest, IsSilentAfterTheStillFrame) {
  pacer.changed(now);
  pacer.asked(FrameKind::interactive, now);
  now += milliseconds(200);
  pacer.asked(FrameKind::still, now);
  EXPECT_EQ(pacer.due(now + std::chrono::hours(1)), std::nullopt);
  EXPECT_EQ(pacer.next_due(now), std::nullopt);
}

TEST_F(PacerTest, EachChangePutsRestOff) {
  pacer.changed(now);
  pacer.asked(FrameKind::interactive, now);
  pacer.changed(now + milliseconds(150));
  pacer.asked(FrameKind::interactive, now + milliseconds(150));
  EXPECT_EQ(pacer.due(now + milliseconds(349)), std::nullopt);
  EXPECT_EQ(pacer.due(now + milliseconds(350)), FrameKind::still);
}

TEST_F(PacerTest, SkipsTheInteractiveFrameThatCouldNotBeMadeBeforeRest) {
  pacer.changed(now);
  EXPECT_EQ(pacer.due(now + milliseconds(300)), FrameKind::still);
  pacer.asked(FrameKind::still, now + milliseconds(300));
  EXPECT_EQ(pacer.due(now + milliseconds(300)), std::nullopt);
}

TEST_F(PacerTest, KeepsTheIntervalBetweenInteractiveFrames) {
  pacer.set_interval(Milliseconds(100.0));
  pacer.changed(now);
  pacer.asked(FrameKind::interactive, now);
  pacer.changed(now + milliseconds(10));
  EXPECT_TRUE(pacer.has_change());
  EXPECT_EQ(pacer.due(now + milliseconds(99)), std::nullopt);
  EXPECT_EQ(pacer.next_due(now + milliseconds(10)), now + milliseconds(100));
  EXPECT_EQ(pacer.due(now + milliseconds(100)), FrameKind::interactive);
}

TEST_F(PacerTest, OwesNothingForASceneThatCannotBeRendered) {
  pacer.changed(now);
  pacer.asked(FrameKind::interactive, now);
  pacer.give_up();
  EXPECT_EQ(pacer.due(now + milliseconds(500)), std::nullopt);
  pacer.changed(now + milliseconds(600));
  EXPECT_EQ(pacer.due(now + milliseconds(600)), FrameKind::interactive);
}

}  // namespace
}  // namespace cutaway
