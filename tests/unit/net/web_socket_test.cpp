// Sessions over real sockets: the upgrade, frames, and clients that behave badly while others are
// watching.
#include <gtest/gtest.h>

#include "scene/frame_header.h"
#include "unit/net/test_client.h"
#include "unit/net/test_server.h"

namespace cutaway {
namespace {

using std::chrono::milliseconds;
using testing::fetch;
using testing::RawClient;
using testing::SocketClient;
using testing::TestServer;

/// Another client of the same server, that goes about its business while one misbehaves.
void expect_undisturbed(SocketClient& client, double radius_mm) {
  client.move_lens(radius_mm);
  const auto frame = client.read_frame();
  ASSERT_TRUE(frame.has_value());
  client.acknowledge(*frame);
}

TEST(WebSocket, AgreesOnTheSubprotocolAndBeginsWithCapabilities) {
  TestServer server;
  SocketClient client(server.port());
  EXPECT_EQ(client.handshake()["Sec-WebSocket-Protocol"], "cutaway.v1");
  EXPECT_EQ(std::get<Json>(client.read().value())["type"], "capabilities");
  EXPECT_EQ(std::get<Json>(client.read().value())["type"], "volumes");
}

TEST(WebSocket, ShowsAVolume) {
  TestServer server;
  SocketClient client(server.port());
  client.show_ball();
  EXPECT_EQ(client.read_until("scene")["scene"]["volume"], "ball");
  const auto frame = client.read_frame();
  ASSERT_TRUE(frame.has_value());
  const DecodedFrame decoded = decode_frame(frame->bytes);
  EXPECT_EQ(decoded.header.frame, 1);
  EXPECT_EQ(decoded.header.input, 2);
  EXPECT_EQ(decoded.header.clock_ms, 2.5);
  EXPECT_EQ(decoded.picture.size(), 5000);
}

TEST(WebSocket, ALargeFrameComesAsOneMessage) {
  TestServer server;
  server.frames.picture_bytes = 3'000'000;
  SocketClient client(server.port());
  client.show_ball();
  EXPECT_EQ(client.read_frame().value().bytes.size(), 3'000'056);
}

TEST(WebSocket, RefusesAnotherSubprotocolNamingItsOwn) {
  TestServer server;
  for (const char* offered : {"", "cutaway.v2", "chat"}) {
    SocketClient client(server.port(), {.subprotocol = offered});
    EXPECT_FALSE(client.is_open());
    EXPECT_EQ(client.handshake().result_int(), 426);
    EXPECT_NE(client.handshake().body().find("cutaway.v1"), std::string::npos);
  }
  SocketClient several(server.port(), {.subprotocol = "cutaway.v2, cutaway.v1"});
  EXPECT_TRUE(several.is_open());
}

TEST(WebSocket, APlainRequestToItIsToldToUpgrade) {
  TestServer server;
  EXPECT_EQ(fetch(server.port(), "/ws").result_int(), 426);
  EXPECT_EQ(fetch(server.port(), "/ws", {}, "POST").result_int(), 405);
}

TEST(WebSocket, RefusesPagesOfOtherOriginsUnlessListed) {
  NetSettings settings = testing::test_settings();
  settings.allowed_origins = {"https://viewer.example"};
  TestServer server(settings);
  SocketClient foreign(server.port(), {.origin = "https://evil.example"});
  EXPECT_EQ(foreign.handshake().result_int(), 403);
  SocketClient listed(server.port(), {.origin = "https://viewer.example"});
  EXPECT_TRUE(listed.is_open());
  SocketClient own(server.port(), {.origin = "http://127.0.0.1:" + std::to_string(server.port())});
  EXPECT_TRUE(own.is_open());
}

TEST(WebSocket, MalformedJsonAndBinaryAreAnsweredAndTheSessionGoesOn) {
  TestServer server;
  SocketClient client(server.port());
  client.send_text("{nonsense");
  EXPECT_EQ(client.read_until("error")["code"], "malformed-json");
  client.send_binary("\x01\x02");
  EXPECT_EQ(client.read_until("error")["code"], "not-text");
  client.show_ball();
  EXPECT_TRUE(client.read_frame().has_value());
}

TEST(WebSocket, AMessageOver64KiBIsAnsweredAndTheSessionGoesOn) {
  TestServer server;
  SocketClient client(server.port());
  client.send_text(std::string(std::size_t{64} * 1024, ' '));
  EXPECT_EQ(client.read_until("error")["code"], "malformed-json");
  for (const std::size_t bytes : {std::size_t{65'537}, std::size_t{3'000'000}}) {
    client.send_text(std::string(bytes, ' '));
    const Json error = client.read_until("error");
    EXPECT_EQ(error["code"], "too-large");
    EXPECT_EQ(error["expected"], "at most 65536 bytes");
    EXPECT_EQ(error["received"], std::to_string(bytes) + " bytes");
  }
  client.send_binary(std::string(100'000, '\1'));
  EXPECT_EQ(client.read_until("error")["code"], "too-large");
  client.show_ball();
  EXPECT_TRUE(client.read_frame().has_value());
}

TEST(WebSocket, AMessageInManySmallPartsIsMeasuredAsOne) {
  NetSettings settings = testing::test_settings();
  settings.message_bytes = 1024;
  TestServer server(settings);
  RawClient client(server.port());
  client.upgrade();
  const std::string mask(4, '\0');
  for (int i = 0; i < 20; ++i) {
    const char opcode = i == 0 ? '\x01' : '\0';  // not final
    client.send(std::string{opcode, '\xE4'} + mask + std::string(100, ' '));
  }
  client.send(std::string{'\x80', '\x80'} + mask);  // the last part, empty
  std::string received;
  while (received.find("2000 bytes") == std::string::npos) {
    const std::string more = client.read_some();
    ASSERT_FALSE(more.empty()) << received;
    received += more;
  }
  EXPECT_NE(received.find("too-large"), std::string::npos);
}

TEST(WebSocket, AMessageFarOverTheLimitClosesWith1009) {
  NetSettings settings = testing::test_settings();
  settings.dropped_message_bytes = 200'000;
  TestServer server(settings);
  SocketClient client(server.port());
  client.send_text(std::string(200'001, ' '));
  EXPECT_EQ(client.read_close_code(), 1009);
}

TEST(WebSocket, ASessionThatFailsIsClosedWith1011AndDisturbsNobody) {
  TestServer server;
  SocketClient failing(server.port());
  failing.read_until("capabilities");  // the first session, then
  SocketClient other(server.port());
  other.show_ball();
  failing.send(
      {{"type", "scene"}, {"input", 1}, {"clock_ms", 0}, {"scene", {{"volume", "broken"}}}});
  EXPECT_EQ(failing.read_close_code(), 1011);
  EXPECT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(0)));
  for (int i = 0; i < 5; ++i) expect_undisturbed(other, i + 10.0);
}

TEST(WebSocket, ASessionThatCannotBeginIsClosedWith1011) {
  TestServer server;
  server.refuse_sessions = true;
  SocketClient client(server.port());
  EXPECT_EQ(client.read_close_code(), 1011);
  server.refuse_sessions = false;
  SocketClient other(server.port());
  other.show_ball();
  EXPECT_TRUE(other.read_frame().has_value());
}

TEST(WebSocket, TextThatIsNotUtf8ClosesWith1007) {
  TestServer server;
  SocketClient client(server.port());
  client.send_text("{\"type\":\"\xC3\x28\"}");
  EXPECT_EQ(client.read_close_code(), 1007);
}

TEST(WebSocket, TheServerFullIsSaidAndClosedWith1013) {
  NetSettings settings = testing::test_settings();
  settings.sessions = 1;
  settings.queued_sessions = 0;
  TestServer server(settings);
  {
    SocketClient first(server.port());
    first.read_until("volumes");
    SocketClient second(server.port());
    EXPECT_EQ(second.read_until("error")["code"], "server-full");
    EXPECT_EQ(second.read_close_code(), 1013);
    expect_undisturbed((first.show_ball(), first), 5.0);
  }
  ASSERT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(0)));
  while (true) {  // the seat is free a moment after the session has ended
    SocketClient third(server.port());
    if (std::get<Json>(third.read().value())["type"] == "capabilities") break;
  }
}

TEST(WebSocket, WhoFindsNoSeatIsToldItsPlaceAndServedInItsTurn) {
  NetSettings settings = testing::test_settings();
  settings.sessions = 1;
  TestServer server(settings);
  auto first = std::make_unique<SocketClient>(server.port());
  first->read_until("volumes");
  auto second = std::make_unique<SocketClient>(server.port());
  EXPECT_EQ(std::get<Json>(second->read().value()), Json::parse(R"({"type":"queued","place":1})"));
  SocketClient third(server.port());
  EXPECT_EQ(std::get<Json>(third.read().value())["place"], 2);
  expect_undisturbed((first->show_ball(), *first), 5.0);
  second.reset();  // gives up
  EXPECT_EQ(std::get<Json>(third.read().value())["place"], 1);
  first.reset();
  EXPECT_EQ(std::get<Json>(third.read().value())["type"], "capabilities");
  third.show_ball();
  EXPECT_TRUE(third.read_frame().has_value());
}

// What is read of it nobody hears; what is not is left for the session, which tells them apart.
TEST(WebSocket, WhoWaitsForASeatIsReadNoFasterThanWhoHasOne) {
  NetSettings settings = testing::test_settings();
  settings.sessions = 1;
  settings.messages = {.per_second = 1.0, .burst = 10.0};
  SessionSettings session;
  session.messages = {.per_second = 1e6, .burst = 1e6};
  TestServer server(settings, session);
  auto first = std::make_unique<SocketClient>(server.port());
  first->show_ball();
  SocketClient waiting(server.port());
  EXPECT_EQ(std::get<Json>(waiting.read().value())["place"], 1);
  for (int i = 0; i < 500; ++i) waiting.send({{"type", "flood"}});
  for (int i = 0; i < 20; ++i) expect_undisturbed(*first, i + 5.0);
  first.reset();
  waiting.read_until("capabilities");
  waiting.send_text("no JSON");
  EXPECT_EQ(waiting.read_until("error")["code"], "unknown-message");
}

TEST(WebSocket, AClientThatNeverAcknowledgesGetsTwoFramesAndDisturbsNobody) {
  TestServer server;
  SocketClient deaf(server.port());
  deaf.read_until("volumes");
  SocketClient other(server.port());
  deaf.show_ball();
  other.show_ball();
  for (int i = 0; i < 2; ++i) {
    deaf.move_lens(i + 1.0);
    ASSERT_TRUE(deaf.read_frame().has_value());
  }
  const int rendered = server.frames.rendered(TestServer::view_of_session(0));
  for (int i = 0; i < 20; ++i) {
    deaf.move_lens(i + 10.0);
    expect_undisturbed(other, i + 10.0);
  }
  EXPECT_EQ(server.frames.rendered(TestServer::view_of_session(0)), rendered);
}

TEST(WebSocket, AClientThatFloodsWithoutReadingIsDroppedAndDisturbsNobody) {
  NetSettings settings = testing::test_settings();
  settings.queued_text_bytes = std::size_t{64} * 1024;
  settings.send_buffer_bytes = 16 * 1024;
  settings.write_timeout = milliseconds(300);
  SessionSettings session;
  session.messages = {.per_second = 1e6, .burst = 1e6};
  TestServer server(settings, session);
  RawClient rude(server.port(), 4096);
  rude.upgrade();
  SocketClient other(server.port());
  other.show_ball();
  std::atomic<bool> dropped = false;
  const std::jthread flood([&] {
    EXPECT_TRUE(rude.flood_until_closed());
    dropped = true;
  });
  for (int i = 0; i < 10 || !dropped; ++i) expect_undisturbed(other, i % 100 + 10.0);
  EXPECT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(0)));
}

TEST(WebSocket, AClientThatDoesNotTakeAFrameInTimeIsDropped) {
  NetSettings settings = testing::test_settings();
  settings.write_timeout = milliseconds(300);
  TestServer server(settings);
  server.frames.picture_bytes = 30'000'000;
  SocketClient stuck(server.port());
  stuck.show_ball();
  EXPECT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(0)));
}

TEST(WebSocket, AClientThatDiesMidFrameLeavesNothingBehind) {
  TestServer server;
  server.frames.picture_bytes = 30'000'000;
  RawClient dying(server.port(), 4096);
  dying.upgrade();
  dying.send_text_frame(
      R"({"type":"viewport","input":1,"clock_ms":0,"width_px":640,"height_px":480})");
  dying.send_text_frame(
      R"({"type":"scene","input":2,"clock_ms":0,"scene":{"volume":"ball"},"replace":false})");
  while (server.frames.rendered(TestServer::view_of_session(0)) == 0) std::this_thread::yield();
  dying.read_some();
  dying.reset();
  EXPECT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(0)));
  server.frames.picture_bytes = 1000;
  SocketClient other(server.port());
  other.show_ball();
  EXPECT_TRUE(other.read_frame().has_value());
}

TEST(WebSocket, FiftyThatSayNothingAreDroppedAfterTheIdleTime) {
  NetSettings settings = testing::test_settings();
  settings.idle_timeout = milliseconds(500);
  TestServer server(settings);
  std::vector<std::unique_ptr<RawClient>> silent;  // they answer no ping
  for (int i = 0; i < 50; ++i) {
    silent.push_back(std::make_unique<RawClient>(server.port()));
    silent.back()->upgrade();
  }
  SocketClient other(server.port());  // its reads answer pings
  other.show_ball();
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(server.frames.wait_for_release(TestServer::view_of_session(i))) << i;
  }
}

TEST(WebSocket, TooManyMessagesAreRefusedNotTheClient) {
  SessionSettings session;
  session.messages = {.per_second = 5.0, .burst = 10.0};
  TestServer server(testing::test_settings(), session);
  SocketClient client(server.port());
  for (int i = 0; i < 40; ++i) client.send({{"type", "cancel_load"}});
  EXPECT_EQ(client.read_until("error")["code"], "rate-limited");
  EXPECT_TRUE(client.is_open());
}

TEST(WebSocket, StoppingSaysGoingAway) {
  TestServer server;
  SocketClient client(server.port());
  client.read_until("volumes");
  std::jthread stopping([&] { server.stop(); });
  EXPECT_EQ(client.read_close_code(), 1001);
}

TEST(WebSocket, StoppingDoesNotWaitForThoseWhoDoNotAnswer) {
  NetSettings settings = testing::test_settings();
  settings.stop_timeout = milliseconds(200);
  TestServer server(settings);
  RawClient silent(server.port());
  RawClient upgraded(server.port());
  upgraded.upgrade();
  server.stop();
  EXPECT_TRUE(server.frames.is_released(TestServer::view_of_session(0)));
}

TEST(WebSocket, ManyClientsAtOnceEachGetTheirFrames) {
  TestServer server;
  std::vector<std::jthread> threads;
  threads.reserve(8);
  for (int c = 0; c < 8; ++c) {
    threads.emplace_back([&server] {
      SocketClient client(server.port());
      client.show_ball();
      for (int i = 0; i < 20; ++i) expect_undisturbed(client, i + 1.0);
    });
  }
}

}  // namespace
}  // namespace cutaway
