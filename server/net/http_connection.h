// One TCP connection: requests one after the other, until one becomes a session.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <optional>

#include "net/connection_context.h"

namespace cutaway {

/// Lives on its own strand. Of a request only its head is read: what exceeds its route's body is
/// answered from there, and the connection ends.
class HttpConnection final : public OpenConnection,
                             public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(boost::asio::ip::tcp::socket&& socket, AsioStrand::Executor strand,
                 ConnectionContext& context);

  /// Takes its place among the connections; false where there is none for it.
  bool enter();
  /// Until the connection has ended; after enter. Throws nothing.
  boost::asio::awaitable<void> run();

  void close() override;
  void abort() override;

 private:
  enum class Reading { complete, malformed, too_long, ended };

  void set_options();
  boost::asio::awaitable<bool> serve_request();
  boost::asio::awaitable<Reading> find_head(HeadScanner& scanner);
  std::variant<HttpRequest, HeadRefusal> head_of(Reading reading, std::size_t length);
  boost::asio::awaitable<bool> serve(HttpRequest request);
  std::optional<HttpResponse> refusal_of(const HttpRequest& request);
  boost::asio::awaitable<bool> respond(HttpResponse response);
  boost::asio::awaitable<void> upgrade(HttpRequest request);
  boost::asio::awaitable<void> end();
  std::string_view received() const;

  boost::beast::tcp_stream stream_;
  AsioStrand::Executor strand_;
  ConnectionContext& context_;
  boost::asio::ip::address peer_;
  ClientAddress client_;
  std::unique_ptr<ConnectionList::Place> place_;
  boost::beast::flat_buffer incoming_{kHeadBytes};
  std::shared_ptr<WebSocket> web_socket_;
  bool ending_ = false;
};

}  // namespace cutaway
