#include "net/admission.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace cutaway {
namespace {

/// Someone who wants a seat, and what it was told.
struct Guest {
  explicit Guest(Admission& admission)
      : ticket(admission.enter([this](int place) { places.push_back(place); })) {}

  std::vector<int> places;
  std::unique_ptr<Admission::Ticket> ticket;
};

TEST(Admission, SeatsWhileThereAreAnyAndQueuesThenTurnsAway) {
  Admission admission(2, 2);
  Guest first(admission);
  Guest second(admission);
  Guest third(admission);
  Guest fourth(admission);
  Guest fifth(admission);
  EXPECT_EQ(first.places, std::vector{0});
  EXPECT_EQ(second.places, std::vector{0});
  EXPECT_EQ(third.places, std::vector{1});
  EXPECT_EQ(fourth.places, std::vector{2});
  EXPECT_FALSE(fifth.ticket);
  EXPECT_TRUE(fifth.places.empty());
}

TEST(Admission, AFreeSeatGoesToTheNextAndAllOthersMoveUp) {
  Admission admission(1, 3);
  std::optional<Guest> seated(std::in_place, admission);
  Guest next(admission);
  Guest last(admission);
  seated.reset();
  EXPECT_EQ(next.places, (std::vector{1, 0}));
  EXPECT_EQ(last.places, (std::vector{2, 1}));
}

TEST(Admission, WhoGivesUpMovesOnlyThoseBehind) {
  Admission admission(1, 3);
  Guest seated(admission);
  Guest before(admission);
  std::optional<Guest> leaving(std::in_place, admission);
  Guest behind(admission);
  leaving.reset();
  EXPECT_EQ(seated.places, std::vector{0});
  EXPECT_EQ(before.places, std::vector{1});
  EXPECT_EQ(behind.places, (std::vector{3, 2}));
}

TEST(Admission, ASeatThatNobodyWaitsForIsFreeForTheNextToCome) {
  Admission admission(1, 0);
  std::optional<Guest> first(std::in_place, admission);
  first.reset();
  Guest second(admission);
  EXPECT_EQ(second.places, std::vector{0});
}

}  // namespace
}  // namespace cutaway
