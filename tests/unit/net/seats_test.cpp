// Many clients and few places, over real sockets: who stays, who gives way, and what they are told.
#include <gtest/gtest.h>

#include "unit/net/test_client.h"
#include "unit/net/test_server.h"

namespace cutaway {
namespace {

using std::chrono::milliseconds;
using testing::fetch;
using testing::RawClient;
using testing::SocketClient;
using testing::TestServer;

constexpr const char* kHog = "127.0.0.2";
constexpr const char* kHonest = "127.0.0.3";

/// Shares bind at once, silence counts for nothing.
NetSettings few_seats(int seats) {
  NetSettings settings = testing::test_settings();
  settings.sessions = seats;
  settings.limit_loopback = true;
  settings.share_wait = milliseconds(0);
  settings.idle_seat = std::chrono::hours(1);
  return settings;
}

std::unique_ptr<SocketClient> client_from(const TestServer& server, const std::string& address) {
  return std::make_unique<SocketClient>(server.port(), SocketClient::Options{.from = address});
}

std::string first_type(SocketClient& client) {
  return std::get<Json>(client.read().value())["type"];
}

TEST(Seats, AHiddenSessionGivesWayAndIsToldSo) {
  NetSettings settings = testing::test_settings();
  settings.sessions = 2;
  settings.idle_seat = milliseconds(0);
  TestServer server(settings);
  SocketClient seen(server.port());
  seen.read_until("capabilities");
  seen.send({{"type", "presence"}, {"visible", true}});
  SocketClient hidden(server.port());
  hidden.read_until("capabilities");
  hidden.send({{"type", "presence"}, {"visible", false}});
  seen.show_ball();
  seen.read_frame();
  SocketClient waiting(server.port());
  EXPECT_EQ(hidden.read_until("error")["code"], "gave-way");
  EXPECT_EQ(hidden.read_close_code(), 4000);
  EXPECT_FALSE(hidden.close_reason().empty());
  EXPECT_FALSE(waiting.read_until("capabilities").is_null());
  seen.move_lens(20.0);
  EXPECT_TRUE(seen.read_frame().has_value());
}

TEST(Seats, OneAddressMayHaveAllAndGivesUpWhatIsBeyondItsShare) {
  TestServer server(few_seats(2));
  const auto first = client_from(server, kHog);
  first->read_until("capabilities");
  const auto second = client_from(server, kHog);
  second->read_until("capabilities");
  first->send({{"type", "presence"}, {"visible", true}});
  first->show_ball();
  first->read_frame();
  const auto honest = client_from(server, kHonest);
  EXPECT_FALSE(honest->read_until("capabilities").is_null());
  EXPECT_EQ(second->read_close_code(), 4000);
  first->move_lens(20.0);
  EXPECT_TRUE(first->read_frame().has_value());
}

TEST(Seats, WhoNeverReadsItsGoodbyeHoldsNoSeat) {
  TestServer server(few_seats(2));
  RawClient deaf(server.port(), 4096, kHog);
  deaf.upgrade();
  RawClient deaf_too(server.port(), 4096, kHog);
  deaf_too.upgrade();
  const auto honest = client_from(server, kHonest);
  EXPECT_FALSE(honest->read_until("capabilities").is_null());
}

TEST(Seats, HoldersOfAllSeatsAndPlacesLeaveRoomForAnother) {
  NetSettings settings = few_seats(8);
  settings.queued_sessions = 12;
  TestServer server(settings);
  std::vector<std::unique_ptr<SocketClient>> holders;
  for (int i = 0; i < 20; ++i) {
    holders.push_back(client_from(server, kHog));
    first_type(*holders.back());  // it has its place before the next comes
  }
  const auto refused = client_from(server, kHog);
  EXPECT_EQ(refused->read_close_code(), 1013);
  const auto honest = client_from(server, kHonest);
  EXPECT_FALSE(honest->read_until("capabilities").is_null());
  EXPECT_EQ(holders.back()->read_close_code(), 1013) << "the last in the queue made room";
}

TEST(Seats, AServerThatStopsWaitsForNobodyWhomItTurnedAway) {
  NetSettings settings = few_seats(1);
  settings.queued_sessions = 0;
  settings.stop_timeout = milliseconds(200);
  TestServer server(settings);
  const auto seated = client_from(server, kHog);
  seated->read_until("capabilities");
  std::vector<std::unique_ptr<SocketClient>> turned_away;
  turned_away.reserve(20);
  for (int i = 0; i < 20; ++i) turned_away.push_back(client_from(server, kHog));
  for (const auto& each : turned_away) each->read_until("error");  // and answer no goodbye
  server.stop();
}

TEST(Seats, LoopbackIsExemptByDefault) {
  NetSettings settings = few_seats(1);
  settings.limit_loopback = false;
  settings.sessions_per_address = 1;
  TestServer server(settings);
  const auto seated = client_from(server, kHog);
  seated->read_until("capabilities");
  const auto second = client_from(server, kHog);
  EXPECT_EQ(first_type(*second), "queued");
}

TEST(Seats, AnAddressHasNoMoreThanItMayAndHearsWhy) {
  NetSettings settings = few_seats(4);
  settings.sessions_per_address = 1;
  TestServer server(settings);
  const auto first = client_from(server, kHog);
  first->read_until("capabilities");
  const auto second = client_from(server, kHog);
  const Json error = second->read_until("error");
  EXPECT_EQ(error["code"], "server-full");
  EXPECT_NE(error["message"].get<std::string>().find("your address"), std::string::npos);
  EXPECT_EQ(second->read_close_code(), 1013);
  EXPECT_FALSE(client_from(server, kHonest)->read_until("capabilities").is_null());
}

TEST(Seats, BehindATrustedProxyClientsAreCountedByThemselves) {
  NetSettings settings = few_seats(8);
  settings.sessions_per_address = 1;
  settings.trusted_proxies = {"127.0.0.1"};
  TestServer server(settings);
  const auto behind = [&](const std::string& forwarded, const std::string& proxy = "127.0.0.1") {
    return std::make_unique<SocketClient>(
        server.port(), SocketClient::Options{.from = proxy, .forwarded_for = forwarded});
  };
  const auto first = behind("198.51.100.1");
  EXPECT_EQ(first_type(*first), "capabilities");
  EXPECT_EQ(first_type(*behind("198.51.100.1")), "error");
  EXPECT_EQ(first_type(*behind("9.9.9.9, 198.51.100.1")), "error")
      << "what a client adds counts not";
  const auto second = behind("198.51.100.2");
  EXPECT_EQ(first_type(*second), "capabilities");
  const auto stranger = behind("198.51.100.3", kHog);
  EXPECT_EQ(first_type(*stranger), "capabilities");
  EXPECT_EQ(first_type(*behind("198.51.100.4", kHog)), "error") << "it is no proxy";
}

TEST(Seats, HalfOpenRequestsHoldNoConnections) {
  NetSettings settings = testing::test_settings();
  settings.connections = 10;
  TestServer server(settings);
  std::vector<std::unique_ptr<RawClient>> half_open;
  for (int i = 0; i < 40; ++i) {
    half_open.push_back(std::make_unique<RawClient>(server.port(), 0, kHog));
    half_open.back()->send("GET / HTTP/1.1\r\nHost: local");
  }
  EXPECT_EQ(fetch(server.port(), "/healthz").result_int(), 200);
  SocketClient session(server.port());
  session.show_ball();
  EXPECT_TRUE(session.read_frame().has_value());
  for (int i = 0; i < 40; ++i) RawClient(server.port(), 0, kHog).send("GET");
  session.move_lens(20.0);
  EXPECT_TRUE(session.read_frame().has_value()) << "a session does not give way to them";
}

TEST(Seats, AFullServerIsReadyAndSaysThatItIsFull) {
  NetSettings settings = testing::test_settings();
  settings.sessions = 1;
  TestServer server(settings);
  const auto readiness = [&] { return Json::parse(fetch(server.port(), "/readyz").body()); };
  EXPECT_EQ(readiness(), Json::parse(R"({"ready":true,"full":false})"));
  SocketClient client(server.port());
  client.read_until("capabilities");
  EXPECT_EQ(fetch(server.port(), "/readyz").result_int(), 200);
  EXPECT_EQ(readiness(), Json::parse(R"({"ready":true,"full":true})"));
}

}  // namespace
}  // namespace cutaway
