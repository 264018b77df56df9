#include "render/fair_share.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <vector>

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

}  // namespace
}  // namespace cutaway
