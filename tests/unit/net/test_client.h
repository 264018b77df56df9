// Clients for tests: every step is bounded in time, and what does not come in time is a failure.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/json.h"

namespace cutaway::testing {

using HttpResponseMessage = boost::beast::http::response<boost::beast::http::string_body>;

/// Bytes over TCP, as no well-behaved client sends them.
class RawClient {
 public:
  /// `from`: an address of this machine, such as 127.0.0.2.
  explicit RawClient(std::uint16_t port, int receive_buffer_bytes = 0,
                     const std::string& from = "127.0.0.1");

  /// False where the server has closed the connection.
  bool send(const std::string& bytes);
  /// Everything until the server closes the connection; nothing where it does not in time.
  std::optional<std::string> read_to_end();
  /// Some bytes; empty where the connection ended.
  std::string read_some();
  /// Sends text frames of 1 KiB without ever reading until the server is seen to have closed; false
  /// where it never does.
  bool flood_until_closed();
  /// A text message, padded with blanks; after upgrade.
  bool send_text_frame(std::string text);
  /// Closes with a reset instead of a goodbye.
  void reset();
  /// A WebSocket from here on, whose session has begun.
  void upgrade();

 private:
  boost::asio::io_context io_;
  boost::asio::ip::tcp::socket socket_{io_};
};

/// One request on a connection of its own.
HttpResponseMessage fetch(std::uint16_t port, const std::string& target,
                          const std::vector<std::pair<std::string, std::string>>& headers = {},
                          const std::string& method = "GET");

class SocketClient {
 public:
  struct Options {
    std::string subprotocol = "cutaway.v1";
    std::string origin;
    std::string target = "/ws";
    std::string from = "127.0.0.1";  ///< an address of this machine, such as 127.0.0.2
    std::string forwarded_for;
  };
  struct Binary {
    std::vector<std::uint8_t> bytes;
  };
  using Message = std::variant<Json, Binary>;

  explicit SocketClient(std::uint16_t port) : SocketClient(port, Options{}) {}
  SocketClient(std::uint16_t port, const Options& options);

  bool is_open() const { return stream_.is_open(); }
  /// What the server answered to the upgrade.
  const HttpResponseMessage& handshake() const { return handshake_; }

  void send(const Json& message) { send_text(message.dump()); }
  void send_text(const std::string& text);
  void send_binary(const std::string& bytes);
  /// The next message; nothing where the connection was closed instead.
  std::optional<Message> read();
  /// Reads on until a text message of this type comes, acknowledging frames on the way; null where
  /// the connection ended.
  Json read_until(const std::string& type);
  /// Reads on until a frame comes, without acknowledging it; nothing where the connection ended.
  std::optional<Binary> read_frame();
  /// Reads until the connection is closed; the code with which.
  std::uint16_t read_close_code();
  /// The close reason that came.
  std::string close_reason() const { return stream_.reason().reason.c_str(); }
  void acknowledge(const Binary& frame);
  /// A volume and a viewport: from here on frames come.
  void show_ball();
  void move_lens(double radius_mm);

 private:
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream>;

  template <typename Start>
  boost::system::error_code finish(Start start);

  boost::asio::io_context io_;
  Stream stream_{io_};
  boost::beast::flat_buffer incoming_;
  HttpResponseMessage handshake_;
  std::uint32_t input_ = 0;
};

}  // namespace cutaway::testing
