#include "net/http_connection.h"

#include <array>
#include <boost/asio/dispatch.hpp>
#include <boost/beast/http/write.hpp>
#include <string>
#include <utility>

#include "core/log.h"
#include "net/host_check.h"
#include "net/upgrade.h"

namespace cutaway {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;

namespace {

constexpr std::size_t kRequestReadBytes = std::size_t{4} * 1024;
/// What a client may still have on its way when it is refused: read, so that the answer arrives
/// before the reset that unread bytes cause (RFC 9112, 9.6).
constexpr std::size_t kLingerBytes = std::size_t{256} * 1024;
constexpr std::chrono::seconds kLinger{1};

HeadRefusal no_request() { return {http::status::bad_request, "This is no HTTP request."}; }

HeadRefusal too_long(std::string_view received) {
  if (received.find("\r\n") == std::string_view::npos) {
    return {http::status::uri_too_long, "The request's first line is longer than 16 KiB."};
  }
  return {http::status::request_header_fields_too_large,
          "The request's header is longer than 16 KiB."};
}

std::string forwarded_for(const HttpRequest& request) {
  std::string all;
  for (const auto& field : request) {
    if (!boost::beast::iequals(field.name_string(), "X-Forwarded-For")) continue;
    if (!all.empty()) all += ',';
    all.append(field.value().data(), field.value().size());
  }
  return all;
}

}  // namespace

HttpConnection::HttpConnection(asio::ip::tcp::socket&& socket, AsioStrand::Executor strand,
                               ConnectionContext& context)
    : stream_(std::move(socket)), strand_(std::move(strand)), context_(context) {
  error_code error;
  peer_ = stream_.socket().remote_endpoint(error).address();
  client_ = context_.addresses.of_peer(peer_);
}

bool HttpConnection::enter() {
  place_ = context_.connections.add(weak_from_this(), client_);
  if (!place_) context_.drops.note("connections were dropped, all are taken", client_.text);
  return place_ != nullptr;
}

void HttpConnection::set_options() {
  error_code ignored;
  stream_.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
  if (const int bytes = context_.settings.send_buffer_bytes; bytes > 0) {
    stream_.socket().set_option(asio::socket_base::send_buffer_size(bytes), ignored);
  }
}

asio::awaitable<void> HttpConnection::run() {
  const auto self = shared_from_this();
  set_options();
  bool more = true;
  while (more && !ending_) more = co_await serve_request();
  if (!web_socket_) co_await end();
  place_.reset();
}

// True where another request may follow on this connection.
asio::awaitable<bool> HttpConnection::serve_request() {
  HeadScanner scanner;
  const Reading reading = co_await find_head(scanner);
  if (reading == Reading::ended) co_return false;
  place_->is_used_as(ConnectionList::Use::answers);
  std::variant<HttpRequest, HeadRefusal> head = head_of(reading, scanner.length());
  if (const auto* refusal = std::get_if<HeadRefusal>(&head)) {
    co_await respond(HttpAnswers::refusal(refusal->status, refusal->reason));
    co_return false;
  }
  const bool more = co_await serve(std::move(std::get<HttpRequest>(head)));
  co_return more;
}

std::variant<HttpRequest, HeadRefusal> HttpConnection::head_of(Reading reading,
                                                               std::size_t length) {
  if (reading == Reading::too_long) return too_long(received());
  if (reading == Reading::malformed) return no_request();
  auto head = read_head(received().substr(0, length));
  incoming_.consume(length);
  return head;
}

std::string_view HttpConnection::received() const {
  const asio::const_buffer bytes = incoming_.cdata();
  return {static_cast<const char*>(bytes.data()), bytes.size()};
}

asio::awaitable<HttpConnection::Reading> HttpConnection::find_head(HeadScanner& scanner) {
  place_->is_used_as(ConnectionList::Use::awaits_request);
  stream_.expires_after(context_.settings.request_timeout);
  HeadScanner::State state = scanner.scan(received());
  while (state == HeadScanner::State::incomplete) {
    const std::size_t room = std::min(kRequestReadBytes, kHeadBytes - incoming_.size());
    if (room == 0) co_return Reading::too_long;
    error_code error;
    const std::size_t bytes = co_await stream_.async_read_some(
        incoming_.prepare(room), asio::redirect_error(asio::use_awaitable, error));
    if (error) co_return Reading::ended;
    incoming_.commit(bytes);
    state = scanner.scan(received());
  }
  co_return state == HeadScanner::State::complete ? Reading::complete : Reading::malformed;
}

asio::awaitable<bool> HttpConnection::serve(HttpRequest request) {
  std::optional<HttpResponse> refusal = refusal_of(request);
  if (refusal) {
    co_await respond(std::move(*refusal));
    co_return false;
  }
  if (!is_web_socket_request(request)) {
    HttpResponse response = context_.answers.answer(request);
    const bool more = co_await respond(std::move(response));
    co_return more;
  }
  refusal = refuse_upgrade(request, context_.settings.allowed_origins);
  if (!refusal && incoming_.size() > 0) {
    refusal = HttpAnswers::refusal(http::status::bad_request,
                                   "A WebSocket's client waits for the answer to its handshake.");
  }
  if (refusal) {
    co_await respond(std::move(*refusal));
  } else {
    co_await upgrade(std::move(request));
  }
  co_return false;
}

// In the order in which a request is judged: for whom, from whom, how much.
std::optional<HttpResponse> HttpConnection::refusal_of(const HttpRequest& request) {
  const boost::beast::string_view host = request[http::field::host];
  if (!host_allowed({host.data(), host.size()}, context_.settings)) {
    return HttpAnswers::refusal(http::status::misdirected_request,
                                allowed_hosts_in_words(context_.settings));
  }
  if (context_.addresses.is_trusted(peer_)) {
    client_ = context_.addresses.of_request(peer_, forwarded_for(request));
    if (!place_->belongs_to(client_)) {
      context_.drops.note("requests were refused, their address has all its connections",
                          client_.text);
      return HttpAnswers::refusal(http::status::too_many_requests,
                                  "This address has all the connections that it may have.");
    }
  }
  if (announces_body_over(request, context_.answers.largest_body(request))) {
    return HttpAnswers::refusal(http::status::payload_too_large, "Requests here have no body.");
  }
  return std::nullopt;
}

asio::awaitable<bool> HttpConnection::respond(HttpResponse response) {
  const bool keep_alive = response.keep_alive();
  error_code error;
  stream_.expires_after(context_.settings.write_timeout);
  co_await http::async_write(stream_, response, asio::redirect_error(asio::use_awaitable, error));
  co_return keep_alive && !error;
}

asio::awaitable<void> HttpConnection::upgrade(HttpRequest request) {
  place_->is_used_as(ConnectionList::Use::session);
  web_socket_ = std::make_shared<WebSocket>(
      std::move(stream_), strand_, context_.settings, context_.make_session,
      WebSocket::Peer{client_, context_.web_sockets.fetch_add(1) + 1});
  co_await web_socket_->serve(std::move(request), context_.admission, context_.drops);
}

asio::awaitable<void> HttpConnection::end() {
  place_->is_used_as(ConnectionList::Use::awaits_request);
  error_code error;
  stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
  stream_.expires_after(kLinger);
  std::array<char, kRequestReadBytes> unread{};
  std::size_t left = kLingerBytes;
  while (!error && !ending_ && left > 0) {
    const std::size_t bytes = co_await stream_.async_read_some(
        asio::buffer(unread), asio::redirect_error(asio::use_awaitable, error));
    left -= std::min(left, bytes);
  }
  stream_.close();
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
