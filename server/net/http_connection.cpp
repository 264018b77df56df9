#include "net/http_connection.h"

#include <boost/asio/dispatch.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <optional>
#include <utility>

#include "core/log.h"
#include "net/host_check.h"
#include "net/upgrade.h"

namespace cutaway {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::uint32_t kHeaderBytes = 16 * 1024;
constexpr std::uint64_t kBodyBytes = std::uint64_t{4} * 1024;  // no request here has one

// What the client is told of a request that could not be read; nothing where it just went away or
// was too slow.
std::optional<HttpResponse> refusal_of(const error_code& error) {
  if (error.category() != make_error_code(http::error::end_of_stream).category()) {
    return std::nullopt;
  }
  if (error == http::error::end_of_stream || error == http::error::partial_message) {
    return std::nullopt;
  }
  if (error == http::error::header_limit) {
    return HttpAnswers::refusal(http::status::request_header_fields_too_large,
                                "The request's header is longer than 16 KiB.");
  }
  if (error == http::error::body_limit) {
    return HttpAnswers::refusal(http::status::payload_too_large,
                                "The request's body is longer than 4 KiB.");
  }
  return HttpAnswers::refusal(http::status::bad_request, "This is no HTTP request.");
}

HttpResponse misdirected() {
  return HttpAnswers::refusal(http::status::misdirected_request,
                              "This server listens on a loopback address and answers only to "
                              "localhost, 127.0.0.1, [::1] and the hosts of the configuration's "
                              "allowed_origins.");
}

}  // namespace

HttpConnection::HttpConnection(asio::ip::tcp::socket&& socket, AsioStrand::Executor strand,
                               ConnectionContext& context)
    : stream_(std::move(socket)), strand_(std::move(strand)), context_(context) {}

asio::awaitable<void> HttpConnection::run() {
  const auto self = shared_from_this();
  error_code ignored;
  stream_.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  if (const int bytes = context_.settings.send_buffer_bytes; bytes > 0) {
    stream_.socket().set_option(asio::socket_base::send_buffer_size(bytes), ignored);
  }
  bool more = true;
  while (more && !ending_) more = co_await serve_request();
  if (web_socket_) co_return;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
}

// True where another request may follow on this connection.
asio::awaitable<bool> HttpConnection::serve_request() {
  http::request_parser<http::string_body> parser;
  parser.header_limit(kHeaderBytes);
  parser.body_limit(kBodyBytes);
  error_code error;
  stream_.expires_after(context_.settings.request_timeout);
  co_await http::async_read(stream_, incoming_, parser,
                            asio::redirect_error(asio::use_awaitable, error));
  if (error) {
    std::optional<HttpResponse> refusal = refusal_of(error);
    if (refusal) co_await respond(std::move(*refusal));
    co_return false;
  }
  HttpRequest request = parser.release();
  const boost::beast::string_view host = request[http::field::host];
  if (!host_allowed({host.data(), host.size()}, context_.settings)) {
    co_await respond(misdirected());
    co_return false;
  }
  if (!is_web_socket_request(request)) {
    HttpResponse response = context_.answers.answer(request);
    const bool more = co_await respond(std::move(response));
    co_return more;
  }
  std::optional<HttpResponse> refusal = refuse_upgrade(request, context_.settings.allowed_origins);
  if (refusal) {
    co_await respond(std::move(*refusal));
  } else {
    co_await upgrade(std::move(request));
  }
  co_return false;
}

asio::awaitable<bool> HttpConnection::respond(HttpResponse response) {
  const bool keep_alive = response.keep_alive();
  error_code error;
  stream_.expires_after(context_.settings.write_timeout);
  co_await http::async_write(stream_, response, asio::redirect_error(asio::use_awaitable, error));
  co_return keep_alive && !error;
}

asio::awaitable<void> HttpConnection::upgrade(HttpRequest request) {
  web_socket_ = std::make_shared<WebSocket>(std::move(stream_), strand_, context_.settings,
                                            context_.make_session);
  co_await web_socket_->serve(std::move(request), context_.admission);
}

void HttpConnection::close() {
  asio::dispatch(strand_, [self = shared_from_this()] {
    self->ending_ = true;
    if (self->web_socket_) return self->web_socket_->close();
    self->stream_.close();
  });
}

void HttpConnection::abort() {
  asio::dispatch(strand_, [self = shared_from_this()] {
    self->ending_ = true;
    if (self->web_socket_) return self->web_socket_->abort();
    self->stream_.close();
  });
}

}  // namespace cutaway
