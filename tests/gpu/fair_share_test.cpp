// Whose turn it is, by counting.
#include "render/fair_share.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include "render/view_turns.h"

namespace cutaway {
namespace {

using Views = std::vector<std::uint64_t>;

TEST(FairShare, WhoAsksForMuchGetsAsMuchAsWhoAsksForLittle) {
  FairShare shares;
  const Views waiting = {1, 2, 3};
  const std::map<std::uint64_t, std::int64_t> step = {{1, 100}, {2, 10}, {3, 10}};
  std::map<std::uint64_t, std::int64_t> had;
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t view = shares.next(waiting);
    shares.charge(view, step.at(view));
    had[view] += step.at(view);
  }
  EXPECT_LE(std::abs(had[1] - had[2]), 100);
  EXPECT_LE(std::abs(had[3] - had[2]), 100);
}

TEST(FairShare, AmongEqualsTheOneThatHasWaitedLongestIsNext) {
  FairShare shares;
  EXPECT_EQ(shares.next(Views{7, 3}), 7U);
  shares.charge(7, 5);
  EXPECT_EQ(shares.next(Views{7, 3}), 3U);
}

TEST(FairShare, WhoWasAwayHasNoClaimToWhatHeDidNotUse) {
  FairShare shares;
  shares.charge(2, 1);
  for (int i = 0; i < 100; ++i) shares.charge(shares.next(Views{1}), 10);
  int turns_of_2 = 0;
  for (int i = 0; i < 10; ++i) {
    const std::uint64_t view = shares.next(Views{1, 2});
    shares.charge(view, 10);
    turns_of_2 += view == 2 ? 1 : 0;
  }
  EXPECT_LE(turns_of_2, 6);
}

TEST(FairShare, AForgottenViewBeginsAnew) {
  FairShare shares;
  shares.charge(shares.next(Views{1, 2}), 1000);
  shares.forget(1);
  EXPECT_EQ(shares.next(Views{1, 2}), 1U);
}

/// Serves them so often, at each view's cost; what each view has had then.
std::map<std::uint64_t, std::int64_t> served(ViewTurns& turns, std::span<const ShareOfView> waiting,
                                             std::map<std::uint64_t, std::int64_t> cost,
                                             int times) {
  std::map<std::uint64_t, std::int64_t> had;
  for (int i = 0; i < times; ++i) {
    const std::uint64_t view = turns.next(waiting);
    const auto who = std::ranges::find(waiting, view, &ShareOfView::view);
    turns.charge(*who, cost.at(view));
    had[view] += cost.at(view);
  }
  return had;
}

// What one session has of the device must not count as if a view of another had had it.
TEST(ViewTurns, AreFairBetweenSessionsAndBetweenTheViewsOfEach) {
  ViewTurns turns;
  const std::vector<ShareOfView> waiting = {{1, 1}, {2, 1}, {3, 1}, {11, 11}, {21, 21}, {22, 21}};
  const std::map<std::uint64_t, std::int64_t> cost = {{1, 100}, {2, 10},  {3, 30},
                                                      {11, 50}, {21, 20}, {22, 70}};
  auto had = served(turns, waiting, cost, 3000);
  const std::int64_t all = had[1] + had[2] + had[3];
  EXPECT_LE(std::abs(all - had[11]), 100);
  EXPECT_LE(std::abs(had[21] + had[22] - had[11]), 100);
  EXPECT_LE(std::abs(had[1] - had[2]), 100);
  EXPECT_LE(std::abs(had[3] - had[2]), 100);
  EXPECT_LE(std::abs(had[21] - had[22]), 100);
}

TEST(ViewTurns, ASessionThatOpensMoreViewsGetsNoMore) {
  ViewTurns turns;
  std::vector<ShareOfView> waiting = {{1, 1}, {11, 11}};
  const std::map<std::uint64_t, std::int64_t> cost = {{1, 10}, {2, 10}, {3, 10}, {4, 10}, {11, 10}};
  served(turns, waiting, cost, 100);
  for (const std::uint64_t view : {2, 3, 4}) waiting.push_back({view, 1});
  auto had = served(turns, waiting, cost, 800);
  EXPECT_LE(std::abs(had[11] - 4000), 10);
  // Nor where it lets go of its first, whose name its share has.
  turns.forget(1);
  waiting.erase(waiting.begin());
  had = served(turns, waiting, cost, 800);
  EXPECT_LE(std::abs(had[11] - 4000), 20);
}

TEST(ViewTurns, AShareBeginsAnewOnceAllItsViewsAreForgotten) {
  ViewTurns turns;
  const std::vector<ShareOfView> waiting = {{1, 1}, {2, 1}, {11, 11}};
  turns.charge(waiting[0], 1000);
  turns.charge(waiting[1], 1000);
  turns.forget(1);
  EXPECT_EQ(turns.next(waiting), 11U);
  turns.forget(1);
  turns.forget(2);
  EXPECT_EQ(turns.next(waiting), 1U);
}

}  // namespace
}  // namespace cutaway
