// Every limit of the network side; the configuration fills it (app/config.h).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "session/token_bucket.h"

namespace cutaway {

struct NetSettings {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;  ///< 0 picks a free one
  int io_threads = 2;
  int connections = 512;            ///< open at once, of every kind
  int connections_per_address = 0;  ///< of them; 0: all
  int sessions = 64;                ///< WebSocket sessions at once
  int queued_sessions = 100;        ///< clients that wait for one
  int sessions_per_address = 0;     ///< sessions and places in the queue; 0: all
  bool limit_loopback = false;      ///< whether limits and shares bind loopback addresses, too
  std::size_t message_bytes = std::size_t{64} * 1024;         ///< one text message from a client
  std::size_t dropped_message_bytes = std::size_t{16} << 20;  ///< a longer one ends the connection
  std::size_t queued_text_bytes = std::size_t{4} * 1024 * 1024;  ///< waiting for a client to read
  MessageRate messages;       ///< of a client that waits for a session, as of one that has one
  int send_buffer_bytes = 0;  ///< the kernel's, of one connection; 0: as the kernel chooses
  std::chrono::milliseconds request_timeout{10'000};  ///< until a request has arrived whole
  std::chrono::milliseconds idle_timeout{30'000};     ///< WebSocket: without a word or a pong
  std::chrono::milliseconds write_timeout{20'000};    ///< one message into the client's hands; a
                                                      ///< still has a second more each 128 KiB
  std::chrono::milliseconds idle_seat{30'000};   ///< hidden and silent for so long, a session gives
                                                 ///< way to whoever waits
  std::chrono::milliseconds share_wait{20'000};  ///< until an address that has more than its share
                                                 ///< gives way to one that has less
  std::chrono::milliseconds stop_timeout{2'000};  ///< for closing handshakes at the end
  /// "https://host:port", beside the server's own; their hosts count as `hosts`, too.
  std::vector<std::string> allowed_origins;
  std::vector<std::string> hosts;  ///< names to which requests may be sent, without a port
  /// Addresses or networks of proxies whose X-Forwarded-For says who the client is.
  std::vector<std::string> trusted_proxies;
  std::filesystem::path web_root;  ///< the built web client; empty for none
  bool operator==(const NetSettings&) const = default;
};

}  // namespace cutaway
