// What RFC 6455 says of frames, sound and unsound: each as bytes over a socket, with the close code
// that is due. After each the server serves the next.
#include <gtest/gtest.h>

#include "unit/net/test_client.h"
#include "unit/net/test_server.h"

namespace cutaway {
namespace {

using testing::RawClient;

constexpr int kStaysOpen = 0;

enum Opcode : unsigned char {
  kMore = 0,
  kText = 1,
  kBinary = 2,
  kClose = 8,
  kPing = 9,
  kPong = 10
};
constexpr unsigned char kFinal = 0x80;
constexpr unsigned char kMasked = 0x80;

std::string byte(unsigned value) { return std::string(1, static_cast<char>(value)); }

std::string big_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += byte((value >> (8U * unsigned(i))) & 0xFFU);
  return text;
}

/// A frame as a client sends it; the mask is 0, so that the payload can be read.
std::string frame(unsigned first, const std::string& payload) {
  const std::string length = payload.size() < 126 ? byte(kMasked | unsigned(payload.size()))
                             : payload.size() < 65536
                                 ? byte(kMasked | 126) + big_endian(payload.size(), 2)
                                 : byte(kMasked | 127) + big_endian(payload.size(), 8);
  return byte(first) + length + std::string(4, '\0') + payload;
}

/// A frame whose length is written in this many bytes, whatever it is.
std::string frame_of_length(unsigned first, std::uint64_t length, int bytes, std::size_t payload) {
  return byte(first) + byte(kMasked | (bytes == 2 ? 126 : 127)) + big_endian(length, bytes) +
         std::string(4, '\0') + std::string(payload, ' ');
}

std::string close_frame(unsigned code, const std::string& reason = "") {
  return frame(kFinal | kClose, big_endian(code, 2) + reason);
}

/// A session whose server's frames are read as they come.
class Session {
 public:
  explicit Session(std::uint16_t port) : client_(port) {
    client_.send(
        "GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Protocol: cutaway.v1\r\n\r\n");
    while (received_.find("\r\n\r\n") == std::string::npos && read()) {
    }
    EXPECT_TRUE(received_.starts_with("HTTP/1.1 101 ")) << received_;
    received_.erase(0, received_.find("\r\n\r\n") + 4);
  }

  void send(const std::string& bytes) { client_.send(bytes); }

  /// The code with which the server closes; kStaysOpen where it answers a ping before. -1 where the
  /// connection ends without a word, -2 where something else than these comes.
  int outcome() {
    client_.send(frame(kFinal | kPing, "are you there"));
    while (true) {
      const auto next = next_frame();
      if (!next) return -1;
      const auto& [first, payload] = *next;
      if (first == (kFinal | kPong) && payload == "are you there") return kStaysOpen;
      if (first == (kFinal | kClose)) return code_of(payload);
      const bool is_known = first == (kFinal | kText) || first == (kFinal | kPong);
      if (!is_known) return -2;
    }
  }

 private:
  static int code_of(const std::string& payload) {
    if (payload.size() < 2) return -1;
    return (static_cast<unsigned char>(payload[0]) << 8) | static_cast<unsigned char>(payload[1]);
  }

  bool read() {
    const std::string more = client_.read_some();
    received_ += more;
    return !more.empty();
  }

  bool want(std::size_t bytes) {
    while (received_.size() < bytes) {
      if (!read()) return false;
    }
    return true;
  }

  std::optional<std::pair<unsigned, std::string>> next_frame() {
    if (!want(2)) return std::nullopt;
    const unsigned first = static_cast<unsigned char>(received_[0]);
    std::size_t length = static_cast<unsigned char>(received_[1]);
    std::size_t begin = 2;
    if (length == 126) {
      if (!want(4)) return std::nullopt;
      length = std::size_t(code_of(received_.substr(2, 2)));
      begin = 4;
    }
    if (!want(begin + length)) return std::nullopt;
    std::string payload = received_.substr(begin, length);
    received_.erase(0, begin + length);
    return std::pair(first, std::move(payload));
  }

  RawClient client_;
  std::string received_;
};

struct FrameCase {
  const char* name;
  std::string bytes;
  int code;
};

void expect_all_frames(const std::vector<FrameCase>& cases) {
  testing::TestServer server;
  for (const FrameCase& each : cases) {
    SCOPED_TRACE(each.name);
    Session session(server.port());
    session.send(each.bytes);
    EXPECT_EQ(session.outcome(), each.code);
    EXPECT_EQ(Session(server.port()).outcome(), kStaysOpen) << "the server serves no more";
  }
}

TEST(WebSocketCorpus, Frames) {
  const std::string text = R"({"type":"cancel_load"})";
  expect_all_frames({
      {"a text", frame(kFinal | kText, text), kStaysOpen},
      {"reserved bit 1 (5.2)", frame(kFinal | 0x40 | kText, text), 1002},
      {"reserved bit 2", frame(kFinal | 0x20 | kText, text), 1002},
      {"reserved bit 3", frame(kFinal | 0x10 | kText, text), 1002},
      {"a reserved bit of a ping", frame(kFinal | 0x40 | kPing, ""), 1002},
      {"opcode 3", frame(kFinal | 3, ""), 1002},
      {"opcode 7", frame(kFinal | 7, ""), 1002},
      {"opcode 11", frame(kFinal | 11, ""), 1002},
      {"opcode 15", frame(kFinal | 15, ""), 1002},
      {"no mask (5.1)", byte(kFinal | kText) + byte(2) + "{}", 1002},
      {"a ping without a mask", byte(kFinal | kPing) + byte(0), 1002},
      {"garbage", std::string(64, '\xFF'), 1002},
      {"an HTTP request", "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n", 1002},
  });
}

TEST(WebSocketCorpus, Lengths) {
  expect_all_frames({
      {"125 bytes", frame(kFinal | kText, std::string(125, ' ')), kStaysOpen},
      {"126 bytes", frame(kFinal | kText, std::string(126, ' ')), kStaysOpen},
      {"65535 bytes", frame(kFinal | kText, std::string(65535, ' ')), kStaysOpen},
      {"65536 bytes", frame(kFinal | kText, std::string(65536, ' ')), kStaysOpen},
      {"125 in two bytes (5.2: not the fewest)", frame_of_length(kFinal | kText, 125, 2, 125),
       1002},
      {"0 in two bytes", frame_of_length(kFinal | kText, 0, 2, 0), 1002},
      {"65535 in eight bytes", frame_of_length(kFinal | kText, 65535, 8, 65535), 1002},
      {"2^63 (5.2: none; its size is seen first)",
       frame_of_length(kFinal | kText, 1ULL << 63U, 8, 100), 1009},
      {"2^64 - 1", frame_of_length(kFinal | kText, ~0ULL, 8, 100), 1009},
      {"2^63 - 1", frame_of_length(kFinal | kText, (1ULL << 63U) - 1, 8, 100), 1009},
      {"2^40 in parts", frame(kText, " ") + frame_of_length(kFinal | kMore, 1ULL << 40U, 8, 100),
       1009},
  });
}

TEST(WebSocketCorpus, Fragments) {
  expect_all_frames({
      {"a text in parts", frame(kText, "{") + frame(kMore, " ") + frame(kFinal | kMore, "}"),
       kStaysOpen},
      {"empty parts", frame(kText, "") + frame(kMore, "") + frame(kFinal | kMore, ""), kStaysOpen},
      {"a ping between parts",
       frame(kText, "{") + frame(kFinal | kPing, "x") + frame(kFinal | kMore, "}"), kStaysOpen},
      {"more of nothing (5.4)", frame(kFinal | kMore, "x"), 1002},
      {"more after the last", frame(kFinal | kText, "{}") + frame(kFinal | kMore, "x"), 1002},
      {"a text within a text", frame(kText, "{") + frame(kFinal | kText, "{}"), 1002},
      {"a binary within a text", frame(kText, "{") + frame(kBinary, "x"), 1002},
      {"a ping in parts (5.5)", frame(kPing, "x") + frame(kFinal | kMore, "y"), 1002},
      {"a close in parts", frame(kClose, big_endian(1000, 2)), 1002},
      {"a pong in parts", frame(kPong, "x"), 1002},
  });
}

TEST(WebSocketCorpus, ControlFrames) {
  std::string flood;
  for (int i = 0; i < 5000; ++i) flood += frame(kFinal | kPing, "ping");
  expect_all_frames({
      {"a ping", frame(kFinal | kPing, "x"), kStaysOpen},
      {"a ping of 125 bytes", frame(kFinal | kPing, std::string(125, 'x')), kStaysOpen},
      {"a ping of 126 bytes (5.5)", frame(kFinal | kPing, std::string(126, 'x')), 1002},
      {"a ping of 65536 bytes", frame(kFinal | kPing, std::string(65536, 'x')), 1002},
      {"a pong that nobody asked for", frame(kFinal | kPong, "x"), kStaysOpen},
      {"5000 pings", flood, kStaysOpen},
  });
}

TEST(WebSocketCorpus, Utf8) {
  expect_all_frames({
      {"umlauts", frame(kFinal | kText, "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80"), kStaysOpen},
      {"a letter cut by the parts", frame(kText, "\xE2\x82") + frame(kFinal | kMore, "\xAC"),
       kStaysOpen},
      {"a lone continuation (8.1)", frame(kFinal | kText, "\x80"), 1007},
      {"a letter cut by the end", frame(kFinal | kText, "\xE2\x82"), 1007},
      {"an overlong slash", frame(kFinal | kText, "\xC0\xAF"), 1007},
      {"a surrogate", frame(kFinal | kText, "\xED\xA0\x80"), 1007},
      {"beyond U+10FFFF", frame(kFinal | kText, "\xF4\x90\x80\x80"), 1007},
      {"bad in the second part", frame(kText, "{") + frame(kMore, "\xFF"), 1007},
      {"any bytes in a binary", frame(kFinal | kBinary, "\xFF\x80"), kStaysOpen},
  });
}

TEST(WebSocketCorpus, ClosesThatAreAnsweredAlike) {
  std::vector<FrameCase> cases = {
      {"no code", frame(kFinal | kClose, ""), 1000},
      {"a reason", close_frame(1000, "bye"), 1000},
      {"a reason of 123 bytes", close_frame(1001, std::string(123, 'x')), 1001}};
  for (const int code :
       {1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 1012, 1013, 3000, 3999, 4000, 4999}) {
    cases.push_back({"a code that may be sent (7.4)", close_frame(unsigned(code)), code});
  }
  expect_all_frames(cases);
}

TEST(WebSocketCorpus, ClosesThatAreNone) {
  std::vector<FrameCase> cases = {
      {"half a code (5.5.1)", frame(kFinal | kClose, "\x03"), 1002},
      {"a reason that is no UTF-8", close_frame(1000, "\xC3\x28"), 1002},
      {"a reason of 124 bytes", close_frame(1000, std::string(124, 'x')), 1002},
  };
  for (const unsigned code :
       {0U, 1U, 999U, 1004U, 1005U, 1006U, 1015U, 1016U, 1100U, 2000U, 2999U, 5000U, 65535U}) {
    cases.push_back({"a code that must not be sent (7.4.2)", close_frame(code), 1002});
  }
  expect_all_frames(cases);
}

}  // namespace
}  // namespace cutaway
