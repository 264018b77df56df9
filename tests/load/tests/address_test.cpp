#include "load/address.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cutaway::load {
namespace {

TEST(Address, HasHostPortAndPath) {
  const Address address = parse_address("ws://127.0.0.1:8080/ws");
  EXPECT_EQ(address.host, "127.0.0.1");
  EXPECT_EQ(address.port, "8080");
  EXPECT_EQ(address.path, "/ws");
}

TEST(Address, TakesTheDefaultsOfTheScheme) {
  const Address address = parse_address("ws://gpu-1.example");
  EXPECT_EQ(address.port, "80");
  EXPECT_EQ(address.path, "/");
}

TEST(Address, TakesIpv6InBrackets) { EXPECT_EQ(parse_address("ws://[::1]:99/ws").host, "::1"); }

TEST(Address, RefusesWhatIsNone) {
  for (const char* text : {"", "http://a/ws", "wss://a/ws", "ws://", "ws://a:b/ws", "ws://::1/ws"})
    EXPECT_THROW(parse_address(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace cutaway::load
