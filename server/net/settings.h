// Every limit of the network side; the configuration fills it (app/config.h).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cutaway {

struct NetSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;  ///< 0 picks a free one
  int io_threads = 2;
  int connections = 512;                                      ///< open at once, of every kind
  int sessions = 64;                                          ///< WebSocket sessions at once
  int queued_sessions = 100;                                  ///< clients that wait for one
  std::size_t message_bytes = std::size_t{64} * 1024;         ///< one text message from a client
  std::size_t dropped_message_bytes = std::size_t{16} << 20;  ///< a longer one ends the connection
  std::size_t queued_text_bytes = std::size_t{4} * 1024 * 1024;  ///< waiting for a client to read
  int send_buffer_bytes = 0;  ///< the kernel's, of one connection; 0: as the kernel chooses
  std::chrono::milliseconds request_timeout{10'000};  ///< until a request has arrived whole
  std::chrono::milliseconds idle_timeout{30'000};     ///< WebSocket: without a word or a pong
  std::chrono::milliseconds write_timeout{20'000};    ///< one message into the client's hands; a
                                                      ///< still has a second more each 128 KiB
  std::chrono::milliseconds stop_timeout{2'000};      ///< for closing handshakes at the end
  /// "https://host:port", beside the server's own. On a loopback address also the hosts to which
  /// requests may be sent, such as that of a proxy's page.
  std::vector<std::string> allowed_origins;
  std::filesystem::path web_root;  ///< the built web client; empty for none
  bool operator==(const NetSettings&) const = default;
};

}  // namespace cutaway
