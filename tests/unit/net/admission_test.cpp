#include "net/admission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <vector>

namespace cutaway {
namespace {

using std::chrono::seconds;
using Why = Admission::Why;

const Admission::TimePoint kStart{};

ClientAddress address(const std::string& name) { return {name, name, false}; }

/// Someone who wants a seat, and what it was told.
struct Guest {
  explicit Guest(Admission& admission, const std::string& from = "a", seconds at = seconds(0)) {
    auto entered = admission.enter(address(from),
                                   {.moved = [this](int place) { places.push_back(place); },
                                    .gives_way = [this](Why reason) { why = reason; }},
                                   kStart + at);
    if (auto* got = std::get_if<std::unique_ptr<Admission::Ticket>>(&entered)) {
      ticket = std::move(*got);
    } else {
      refusal = std::get<Admission::Refusal>(entered);
    }
  }

  bool is_seated() const { return !why && !places.empty() && places.back() == 0; }

  std::vector<int> places;
  std::optional<Why> why;
  std::optional<Admission::Refusal> refusal;
  std::unique_ptr<Admission::Ticket> ticket;
};

/// `count` more from one address.
void fill(std::deque<Guest>& guests, Admission& admission, int count, const std::string& from) {
  for (int i = 0; i < count; ++i) guests.emplace_back(admission, from);
}

int seated(const std::deque<Guest>& guests) {
  return static_cast<int>(std::ranges::count_if(guests, &Guest::is_seated));
}

TEST(Admission, SeatsWhileThereAreAnyAndQueuesThenTurnsAway) {
  Admission admission({.seats = 2, .queue = 2});
  EXPECT_FALSE(admission.is_full());
  Guest first(admission);
  Guest second(admission);
  EXPECT_TRUE(admission.is_full());
  Guest third(admission);
  Guest fourth(admission);
  Guest fifth(admission);
  EXPECT_EQ(first.places, std::vector{0});
  EXPECT_EQ(second.places, std::vector{0});
  EXPECT_EQ(third.places, std::vector{1});
  EXPECT_EQ(fourth.places, std::vector{2});
  EXPECT_EQ(fifth.refusal, Admission::Refusal::full);
  EXPECT_TRUE(fifth.places.empty());
}

TEST(Admission, AFreeSeatGoesToTheNextAndAllOthersMoveUp) {
  Admission admission({.seats = 1, .queue = 3});
  std::optional<Guest> seated(std::in_place, admission);
  Guest next(admission);
  Guest last(admission);
  seated.reset();
  EXPECT_EQ(next.places, (std::vector{1, 0}));
  EXPECT_EQ(last.places, (std::vector{2, 1}));
}

TEST(Admission, WhoGivesUpMovesOnlyThoseBehind) {
  Admission admission({.seats = 1, .queue = 3});
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
  Admission admission({.seats = 1, .queue = 0});
  std::optional<Guest> first(std::in_place, admission);
  first.reset();
  Guest second(admission);
  EXPECT_EQ(second.places, std::vector{0});
}

TEST(Admission, AnAddressMayHaveAllUntilAnotherWaits) {
  Admission admission({.seats = 4, .queue = 4});
  std::deque<Guest> own;
  fill(own, admission, 8, "class");
  admission.make_room(kStart + seconds(20));
  EXPECT_EQ(seated(own), 4);
}

TEST(Admission, WhatAnAddressWantsBeyondItsShareComesBehindTheOthers) {
  Admission admission({.seats = 4, .queue = 4});
  std::deque<Guest> own;
  fill(own, admission, 6, "class");
  Guest other(admission, "home");
  EXPECT_EQ(other.places, std::vector{1});
  EXPECT_EQ(own[4].places, (std::vector{1, 2}));
  EXPECT_EQ(own[5].places, (std::vector{2, 3}));
  own[0].ticket.reset();
  EXPECT_TRUE(other.is_seated());
}

TEST(Admission, AfterTheWaitTheMostSilentSeatBeyondTheShareGivesWay) {
  Admission admission({.seats = 4, .queue = 4, .idle_seat = seconds(1000)});
  std::deque<Guest> own;
  fill(own, admission, 4, "class");
  for (const int i : {0, 1, 3}) own[i].ticket->heard(true, kStart + seconds(5));
  own[2].ticket->heard(true, kStart + seconds(3));
  Guest other(admission, "home", seconds(10));
  admission.make_room(kStart + seconds(29));
  EXPECT_FALSE(other.is_seated());
  admission.make_room(kStart + seconds(30));
  EXPECT_TRUE(other.is_seated());
  EXPECT_EQ(own[2].why, Why::over_share);
  EXPECT_EQ(seated(own), 3);
}

TEST(Admission, WhoGaveWayHasNoClaimToComeBackBefore) {
  Admission admission({.seats = 2, .queue = 4, .idle_seat = seconds(1000)});
  std::deque<Guest> own;
  fill(own, admission, 2, "class");
  Guest other(admission, "home");
  admission.make_room(kStart + seconds(20));
  ASSERT_TRUE(other.is_seated());
  Guest again(admission, "class", seconds(20));
  admission.make_room(kStart + seconds(1000 - 1));
  EXPECT_FALSE(again.is_seated());
  EXPECT_TRUE(other.is_seated());
  EXPECT_EQ(seated(own), 1);
}

TEST(Admission, AShareIsOfAllWhoHaveOrWantOne) {
  Admission admission({.seats = 4, .queue = 100, .idle_seat = seconds(1000)});
  std::deque<Guest> own;
  fill(own, admission, 4, "class");
  std::deque<Guest> others;
  for (const char* from : {"x", "y", "z"}) fill(others, admission, 3, from);
  admission.make_room(kStart + seconds(20));
  EXPECT_EQ(seated(own), 1);
  EXPECT_EQ(seated(others), 3);
  for (int i = 0; i < 9; i += 3) EXPECT_TRUE(others[i].is_seated()) << i;
}

TEST(Admission, AHiddenSilentSeatGivesWayWhileSomeoneWaits) {
  Admission admission({.seats = 3, .queue = 4});
  Guest seen(admission);
  Guest hidden(admission);
  Guest never_said(admission);
  seen.ticket->heard(true, kStart + seconds(1));
  hidden.ticket->heard(false, kStart + seconds(5));
  admission.make_room(kStart + seconds(1000));
  EXPECT_FALSE(hidden.why || never_said.why) << "nobody waits";
  Guest waiting(admission, "a", seconds(1000));
  admission.make_room(kStart + seconds(1000));
  EXPECT_EQ(never_said.why, Why::idle);
  EXPECT_TRUE(waiting.is_seated());
  EXPECT_FALSE(hidden.why || seen.why) << "one was enough";
  Guest another(admission, "a", seconds(1000));
  admission.make_room(kStart + seconds(1000));
  EXPECT_EQ(hidden.why, Why::idle);
  Guest third(admission, "a", seconds(1001));
  admission.make_room(kStart + seconds(1001));
  EXPECT_FALSE(seen.why || waiting.why) << "who has just come has its whole idle time";
}

TEST(Admission, OfAFullQueueTheLastBeyondItsShareMakesRoom) {
  Admission admission({.seats = 1, .queue = 4});
  std::deque<Guest> own;
  fill(own, admission, 5, "class");
  Guest again(admission, "class");
  EXPECT_EQ(again.refusal, Admission::Refusal::full);
  Guest first(admission, "home");
  EXPECT_EQ(own[4].why, Why::queue_full);
  EXPECT_EQ(first.places, std::vector{1});
  Guest second(admission, "home");
  EXPECT_EQ(own[3].why, Why::queue_full);
  Guest third(admission, "home");
  EXPECT_EQ(third.refusal, Admission::Refusal::full) << "each has its half";
}

TEST(Admission, HoldersOfEverythingLeaveRoomForAnotherWithinAMinute) {
  Admission admission({.seats = 64, .queue = 100});
  std::deque<Guest> holders;
  fill(holders, admission, 164, "hog");
  Guest honest(admission, "home", seconds(1));
  for (auto& each : holders) {  // they lie
    if (each.ticket) each.ticket->heard(true, kStart + seconds(50));
  }
  for (int second = 1; second <= 60 && !honest.is_seated(); ++second) {
    admission.make_room(kStart + seconds(second));
  }
  EXPECT_TRUE(honest.is_seated());
  EXPECT_EQ(seated(holders), 63);
}

/// It comes back every few seconds, as pages do.
TEST(Admission, WithoutAQueueTheShareBindsForThoseWhoComeBack) {
  Admission admission({.seats = 4, .queue = 0, .idle_seat = seconds(1000)});
  std::deque<Guest> own;
  fill(own, admission, 4, "class");
  for (const int i : {0, 1, 3}) own[i].ticket->heard(true, kStart + seconds(5));
  for (int second = 10; second < 30; second += 5) {
    EXPECT_EQ(Guest(admission, "home", seconds(second)).refusal, Admission::Refusal::full);
    EXPECT_EQ(Guest(admission, "class", seconds(second)).refusal, Admission::Refusal::full);
  }
  EXPECT_EQ(seated(own), 4);
  Guest home(admission, "home", seconds(30));
  EXPECT_TRUE(home.is_seated());
  EXPECT_EQ(own[2].why, Why::over_share);
  EXPECT_EQ(Guest(admission, "class", seconds(60)).refusal, Admission::Refusal::full)
      << "who gave way has no claim";
  EXPECT_TRUE(home.is_seated());
}

TEST(Admission, WithoutAQueueASeatThatComesFreeIsForWhoWasTurnedAway) {
  Admission admission({.seats = 2, .queue = 0});
  std::deque<Guest> own;
  fill(own, admission, 2, "class");
  EXPECT_EQ(Guest(admission, "home").refusal, Admission::Refusal::full);
  own[0].ticket.reset();
  EXPECT_EQ(Guest(admission, "class", seconds(1)).refusal, Admission::Refusal::full);
  EXPECT_TRUE(Guest(admission, "home", seconds(10)).is_seated());
}

TEST(Admission, WithoutAQueueAClaimEndsWithTheComingBack) {
  Admission admission({.seats = 2, .queue = 0, .idle_seat = seconds(1000)});
  std::deque<Guest> own;
  fill(own, admission, 2, "class");
  EXPECT_EQ(Guest(admission, "home").refusal, Admission::Refusal::full);
  own[0].ticket.reset();
  EXPECT_TRUE(Guest(admission, "class", seconds(60)).is_seated());
}

TEST(Admission, WithoutAQueueAHiddenSilentSeatGivesWayToWhoComes) {
  Admission admission({.seats = 1, .queue = 0});
  Guest hidden(admission);
  EXPECT_EQ(Guest(admission, "a", seconds(29)).refusal, Admission::Refusal::full);
  Guest next(admission, "a", seconds(31));
  EXPECT_TRUE(next.is_seated());
  EXPECT_EQ(hidden.why, Why::idle);
}

TEST(Admission, AnAddressHasNoMoreThanItMay) {
  Admission admission({.seats = 8, .queue = 8, .per_address = 2});
  Guest first(admission);
  Guest second(admission);
  Guest third(admission);
  EXPECT_EQ(third.refusal, Admission::Refusal::address_limit);
  EXPECT_TRUE(Guest(admission, "b").is_seated());
}

}  // namespace
}  // namespace cutaway
