// Bytes of a client that has just connected: an answer with a status, or the connection closed.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <string_view>

#include "core/check.h"
#include "core/log.h"
#include "fuzz/planted_fault.h"
#include "unit/net/test_server.h"

namespace {

using namespace cutaway;

sockaddr_in place(in_addr_t address, std::uint16_t port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(address);
  return place;
}

const sockaddr* as_any(const sockaddr_in& place) {
  return reinterpret_cast<const sockaddr*>(&place);
}

/// Of 127.1.0.0/16 in turn: one address has no more than 28,000 ports a minute.
in_addr_t next_source_address() {
  static std::uint16_t last = 0;
  return 0x7F010000 + ++last;
}

class Connection {
 public:
  explicit Connection(std::uint16_t port) {
    const sockaddr_in from = place(next_source_address(), 0);
    check(bind(socket_, as_any(from), sizeof(from)) == 0, "an address of this machine is free");
    const sockaddr_in to = place(INADDR_LOOPBACK, port);
    while (connect(socket_, as_any(to), sizeof(to)) != 0 && errno != EISCONN) {
      check(errno == EINTR || errno == EALREADY, "the server takes connections");
    }
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void say(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) return;  // the server has ended it: its answer is judged
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// What comes next; empty at the end, for which the fuzzer's own limit alone waits.
  std::string hear() const {
    char some[4096];
    ssize_t count = 0;
    do count = recv(socket_, some, sizeof(some), 0);
    while (count < 0 && errno == EINTR);  // by the timer with which the fuzzer watches itself
    check(count >= 0 || errno == ECONNRESET, "the server ends the connection of one who has left");
    return {some, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }

  std::string hear_to_end() const {
    std::string all;
    for (std::string next = hear(); !next.empty(); next = hear()) all += next;
    return all;
  }

  void leave() const { shutdown(socket_, SHUT_WR); }

 private:
  int socket_ = socket(AF_INET, SOCK_STREAM, 0);
};

/// Its clocks stand still: what ends a connection here is what came over it. The log is made before
/// it, to be there as long: the server's end says a word.
testing::TestServer& server() {
  log();
  static testing::TestServer server = [] {
    constexpr std::chrono::hours kNever{24};
    NetSettings settings = testing::test_settings();
    settings.request_timeout = settings.idle_timeout = settings.write_timeout = kNever;
    return testing::TestServer(settings);
  }();
  return server;
}

/// The head that asks for a session, whose frames are only taken after its answer; else everything.
std::size_t length_before_answer(std::string_view bytes) {
  constexpr std::string_view kEnd = "\r\n\r\n";
  const std::size_t end = bytes.find(kEnd);
  const bool answers = bytes.starts_with("GET /ws HTTP/1.1\r\n") && end != bytes.npos;
  return answers ? end + kEnd.size() : bytes.size();
}

constexpr std::string_view kNotText = "\x03\xEF";  // 1007, as a close frame says it

/// Of JSON, which a session says else, no byte is that of a code.
bool is_closed_for(std::string_view code, std::string_view answer) {
  return answer.starts_with("HTTP/1.1 101 ") && answer.find(code) != answer.npos;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t first = length_before_answer(bytes);
  const Connection connection(server().port());
  connection.say(bytes.substr(0, first));
  std::string answer;
  if (first < size) answer = connection.hear();
  connection.say(bytes.substr(first));
  connection.leave();
  answer += connection.hear_to_end();
  check(answer.empty() || answer.starts_with("HTTP/1."), "what comes back is HTTP");
  fuzz::planted_fault(is_closed_for(kNotText, answer));
  return 0;
}
