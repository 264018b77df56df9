// One TCP connection: requests one after the other, until one becomes a session.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "net/admission.h"
#include "net/connection_list.h"
#include "net/web_socket.h"

namespace cutaway {

/// What all connections share; outlives them.
struct ConnectionContext {
  NetSettings settings;
  HttpAnswers answers;
  SessionFactory make_session;
  Admission admission{settings.sessions, settings.queued_sessions};
};

/// Lives on its own strand.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(boost::asio::ip::tcp::socket&& socket, AsioStrand::Executor strand,
                 ConnectionContext& context);

  /// Until the connection has ended. Throws nothing.
  boost::asio::awaitable<void> run();

  /// Ends it: a session with a closing handshake, all else at once. Any thread.
  void close();
  /// Ends it at once. Any thread.
  void abort();

  const AsioStrand::Executor& strand() const { return strand_; }

 private:
  boost::asio::awaitable<bool> serve_request();
  boost::asio::awaitable<bool> respond(HttpResponse response);
  boost::asio::awaitable<void> upgrade(HttpRequest request);

  boost::beast::tcp_stream stream_;
  AsioStrand::Executor strand_;
  ConnectionContext& context_;
  boost::beast::flat_buffer incoming_;
  std::shared_ptr<WebSocket> web_socket_;
  bool ending_ = false;
};

}  // namespace cutaway
