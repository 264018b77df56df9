#include "net/client_address.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace cutaway {
namespace {

using boost::asio::ip::make_address;

const ClientAddresses kPlain({}, false);

TEST(ClientAddress, CountsIpv4WholeAndIpv6ByItsNetwork) {
  EXPECT_EQ(kPlain.of_peer(make_address("203.0.113.7")).group, "203.0.113.7");
  EXPECT_EQ(kPlain.of_peer(make_address("::ffff:203.0.113.7")).group, "203.0.113.7");
  EXPECT_EQ(kPlain.of_peer(make_address("2001:db8:1:2:3::4")).group, "2001:db8:1:2::/64");
  EXPECT_EQ(kPlain.of_peer(make_address("2001:db8:1:2:ffff::9")).group, "2001:db8:1:2::/64");
  EXPECT_NE(kPlain.of_peer(make_address("2001:db8:1:3::4")).group, "2001:db8:1:2::/64");
}

TEST(ClientAddress, LoopbackIsExemptUnlessSet) {
  const ClientAddress first = kPlain.of_peer(make_address("127.0.0.2"));
  const ClientAddress second = kPlain.of_peer(make_address("127.0.0.2"));
  EXPECT_TRUE(first.is_exempt);
  EXPECT_NE(first.group, second.group);
  EXPECT_EQ(first.text, "127.0.0.2");
  const ClientAddresses limiting({}, true);
  EXPECT_FALSE(limiting.of_peer(make_address("127.0.0.2")).is_exempt);
  EXPECT_EQ(limiting.of_peer(make_address("::1")).group, "::/64");
  EXPECT_FALSE(kPlain.of_peer(make_address("203.0.113.7")).is_exempt);
}

TEST(ClientAddress, BehindProxiesIsTheLastThatIsNoneOfThem) {
  const ClientAddresses behind({"10.0.0.0/8", "fd00::/8"}, false);
  const auto client = [&](const char* peer, const char* forwarded) {
    return behind.of_request(make_address(peer), forwarded).text;
  };
  EXPECT_EQ(client("10.0.0.1", "198.51.100.1"), "198.51.100.1");
  EXPECT_EQ(client("10.0.0.1", "1.2.3.4, 198.51.100.1"), "198.51.100.1");
  EXPECT_EQ(client("10.0.0.1", "1.2.3.4,198.51.100.1,\t10.9.9.9 "), "198.51.100.1");
  EXPECT_EQ(client("fd00::1", "2001:db8::1, 10.9.9.9"), "2001:db8::1");
  EXPECT_EQ(client("10.0.0.1", "198.51.100.1:4711"), "198.51.100.1");
  EXPECT_EQ(client("10.0.0.1", "[2001:db8::1]:4711"), "2001:db8::1");
  EXPECT_EQ(client("::ffff:10.0.0.1", "198.51.100.1"), "198.51.100.1");
}

TEST(ClientAddress, WhoIsNoProxySaysNothingAboutItself) {
  const ClientAddresses behind({"10.0.0.1"}, false);
  const ClientAddress client = behind.of_request(make_address("203.0.113.7"), "198.51.100.1");
  EXPECT_EQ(client.text, "203.0.113.7");
}

/// A proxy on this machine passes on what others wrote.
TEST(ClientAddress, LoopbackByHearsayCounts) {
  const ClientAddresses behind({"127.0.0.1", "10.0.0.0/8"}, false);
  for (const char* said : {"127.0.0.2", "::1", "::ffff:127.0.0.2", "127.0.0.2, 10.0.0.2"}) {
    const ClientAddress client = behind.of_request(make_address("127.0.0.1"), said);
    EXPECT_FALSE(client.is_exempt) << said;
    EXPECT_EQ(client.group, client.text == "::1" ? "::/64" : "127.0.0.2") << said;
  }
  EXPECT_FALSE(behind.of_request(make_address("127.0.0.1"), "127.0.0.1").is_exempt);
  EXPECT_TRUE(behind.of_request(make_address("127.0.0.1"), "").is_exempt);
}

TEST(ClientAddress, WhatIsNoAddressIsTheProxysOwnAndCounts) {
  const ClientAddresses behind({"10.0.0.1"}, false);
  for (const char* nonsense : {"unknown", "1.2.3.4, _hidden", "1.2.3.4,", "999.1.1.1", "[::1"}) {
    const ClientAddress client = behind.of_request(make_address("10.0.0.1"), nonsense);
    EXPECT_EQ(client.group, "10.0.0.1") << nonsense;
    EXPECT_FALSE(client.is_exempt) << nonsense;
  }
  EXPECT_TRUE(behind.of_request(make_address("10.0.0.1"), "").is_exempt);
}

TEST(ClientAddress, AProxyHasToBeAnAddress) {
  for (const char* bad : {"proxy.example", "10.0.0.0/33", "10.0.0/8", "", "fd00::/129"}) {
    EXPECT_THROW(TrustedProxies({bad}), Error) << bad;
  }
}

}  // namespace
}  // namespace cutaway
