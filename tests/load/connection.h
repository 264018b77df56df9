// One WebSocket to the server, with a simulated link between.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <optional>
#include <string>

#include "load/address.h"
#include "load/awaitable.h"
#include "load/delay_line.h"
#include "load/link.h"

namespace cutaway::load {

/// A message at the moment of its arrival.
struct Arrival {
  bool text = false;
  std::string content;
};

/// Everything on the executor's one thread. Messages either way are late by the link's delay; what
/// comes is read no faster than the link would carry it, so that the server meets a full socket
/// where the link is the limit.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(const boost::asio::any_io_executor& executor, const LinkSettings& link);

  /// Throws boost::system::system_error, and std::runtime_error with the server's words where it
  /// refuses.
  boost::asio::awaitable<void> open(Address address);
  /// The next message; nothing once the connection has ended.
  boost::asio::awaitable<std::optional<Arrival>> receive();
  void send(std::string text);
  /// Nothing is read between these two times.
  void stop_reading(TimePoint from, TimePoint until);
  /// Begins the closing handshake; what is still under way is lost.
  void close();

  /// Why it has ended, where it was not `close`.
  const std::string& end_reason() const { return end_reason_; }

 private:
  using Stream = boost::beast::websocket::stream<boost::asio::ip::tcp::socket, false>;

  boost::asio::awaitable<void> connect(Address address);
  boost::asio::awaitable<void> shake_hands(Address address);
  boost::asio::awaitable<void> read_all();
  boost::asio::awaitable<void> write_all();
  boost::asio::awaitable<void> wait_until(TimePoint time);
  boost::asio::awaitable<void> cut_after_grace();
  void set_socket_options();
  void take_message(TimePoint transferred);
  void end(const std::string& reason);

  boost::asio::any_io_executor executor_;
  Stream stream_;
  SimulatedLink link_;
  boost::beast::flat_buffer incoming_;
  DelayLine<Arrival> arriving_;
  DelayLine<std::string> leaving_;
  boost::asio::steady_timer reading_timer_;
  boost::asio::steady_timer grace_timer_;
  TimePoint stop_from_ = TimePoint::max();
  TimePoint stop_until_ = TimePoint::max();
  std::string end_reason_;
  bool closing_ = false;
  bool ended_ = false;
};

}  // namespace cutaway::load
