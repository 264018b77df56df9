#include "net/connection_list.h"

#include <gtest/gtest.h>

#include <vector>

namespace cutaway {
namespace {

using Use = ConnectionList::Use;

struct Connection final : OpenConnection {
  void close() override {}
  void abort() override { aborted = true; }
  bool aborted = false;
};

ClientAddress address_of(const std::string& name) { return {name, name, false}; }

/// One that came from `group`, if there was room for it.
struct Client {
  Client(ConnectionList& list, const std::string& group)
      : place(list.add(connection, address_of(group))) {}
  Client(ConnectionList& list, const std::string& group, Use use) : Client(list, group) {
    if (place) place->is_used_as(use);
  }

  bool is_in() const { return place && !connection->aborted; }

  std::shared_ptr<Connection> connection = std::make_shared<Connection>();
  std::unique_ptr<ConnectionList::Place> place;
};

TEST(ConnectionList, TheLongestHalfOpenOneOfTheGreediestAddressGivesWay) {
  ConnectionList list(4, 0);
  const Client honest(list, "b");
  const Client first(list, "a");
  const Client second(list, "a");
  const Client third(list, "a");
  const Client newcomer(list, "c");
  EXPECT_TRUE(newcomer.is_in());
  EXPECT_FALSE(first.is_in());
  EXPECT_TRUE(honest.is_in() && second.is_in() && third.is_in());
}

TEST(ConnectionList, WhatIsServedStaysWhileAnotherWaitsForARequest) {
  ConnectionList list(3, 0);
  const Client session(list, "a", Use::session);
  const Client answered(list, "a", Use::answers);
  const Client half_open(list, "a");
  EXPECT_TRUE(Client(list, "a").is_in());
  EXPECT_FALSE(half_open.is_in());
  EXPECT_TRUE(session.is_in() && answered.is_in());
}

TEST(ConnectionList, WhereNoneWaitsAShareBinds) {
  ConnectionList list(4, 0);
  const Client session(list, "a", Use::session);
  const Client later(list, "a", Use::session);
  const Client slow(list, "a", Use::answers);
  const Client more(list, "a", Use::session);
  EXPECT_FALSE(Client(list, "a").is_in()) << "one's own have no claim to one's own";
  const Client other(list, "b", Use::session);
  EXPECT_TRUE(other.is_in());
  EXPECT_FALSE(slow.is_in());
  const Client another(list, "b", Use::session);
  EXPECT_TRUE(another.is_in());
  EXPECT_FALSE(session.is_in());
  EXPECT_FALSE(Client(list, "b").is_in()) << "both have their half";
}

TEST(ConnectionList, WhoWasToldToLeaveIsNotCountedAndNotToldTwice) {
  ConnectionList list(1, 0);
  std::vector<std::unique_ptr<Client>> all;
  for (int i = 0; i < 5; ++i) all.push_back(std::make_unique<Client>(list, "a"));
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(all[i]->is_in()) << i;
  EXPECT_TRUE(all.back()->is_in());
  EXPECT_EQ(list.size(), 5);
  all.clear();
  EXPECT_EQ(list.size(), 0);
  EXPECT_TRUE(Client(list, "a").is_in());
}

TEST(ConnectionList, AnAddressHasNoMoreThanItMay) {
  ConnectionList list(10, 2);
  const Client first(list, "a");
  const Client second(list, "a");
  EXPECT_FALSE(Client(list, "a").is_in());
  EXPECT_TRUE(Client(list, "b").is_in());
  const Client behind_proxy(list, "proxy");
  EXPECT_FALSE(behind_proxy.place->belongs_to(address_of("a")));
  EXPECT_TRUE(behind_proxy.place->belongs_to(address_of("c")));
}

}  // namespace
}  // namespace cutaway
