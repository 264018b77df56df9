// Bytes of a client that has just connected: an answer with a status, or the connection closed.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>

#include "core/check.h"
#include "fuzz/planted_fault.h"
#include "unit/net/test_server.h"

namespace {

using namespace cutaway;

class Connection {
 public:
  explicit Connection(std::uint16_t port) {
    const timeval generous{.tv_sec = 30, .tv_usec = 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &generous, sizeof(generous));
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    check(connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof(place)) == 0,
          "the server takes connections");
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Everything that comes back once all of it was said.
  std::string answer_to(const std::uint8_t* data, std::size_t size) const {
    (void)::send(socket_, data, size, MSG_NOSIGNAL);
    shutdown(socket_, SHUT_WR);
    std::string answer;
    char some[4096];
    ssize_t count = 0;
    while ((count = recv(socket_, some, sizeof(some), 0)) > 0) {
      answer.append(some, static_cast<std::size_t>(count));
    }
    check(count == 0 || errno == ECONNRESET, "the server ends the connection of one who has left");
    return answer;
  }

 private:
  int socket_ = socket(AF_INET, SOCK_STREAM, 0);
};

testing::TestServer& server() {
  static testing::TestServer server;
  return server;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string answer = Connection(server().port()).answer_to(data, size);
  check(answer.empty() || answer.starts_with("HTTP/1."), "what comes back is HTTP");
  fuzz::planted_fault(answer.find(" 426 ") == 8);
  return 0;
}
