#include "load/connection.h"

#include <netinet/tcp.h>

#include <boost/asio/connect.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket/error.hpp>
#include <stdexcept>

namespace cutaway::load {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

namespace {

constexpr const char* kSubprotocol = "cutaway.v1";
constexpr std::size_t kMessageBytes = std::size_t{256} << 20;
constexpr std::chrono::seconds kGrace{1};  // for the closing handshake
// As on a real link, and not loopback's 64 KiB, which leave a small receive window no steps.
constexpr int kSegmentBytes = 1448;

using SegmentSize = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_MAXSEG>;

/// A refusal's own words where they are words: a page is for browsers.
std::string words_of(const websocket::response_type& response, const Address& address) {
  constexpr std::size_t kLongest = 300;
  const unsigned status = response.result_int();
  const std::string answer = "the server answers " + std::to_string(status);
  const auto type = response[beast::http::field::content_type];
  const bool is_page = type.find("html") != beast::string_view::npos;
  if (status < 400 || response.result() == beast::http::status::not_found || is_page) {
    return answer + " and no WebSocket at the path " + address.path +
           "; expected ws://HOST:PORT/ws, where Cutaway's is";
  }
  return answer + ": " + response.body().substr(0, kLongest);
}

}  // namespace

Connection::Connection(const asio::any_io_executor& executor, const LinkSettings& link)
    : executor_(executor),
      stream_(executor),
      link_(link),
      arriving_(executor),
      leaving_(executor),
      reading_timer_(executor),
      grace_timer_(executor) {}

asio::awaitable<void> Connection::open(Address address) {
  const auto self = shared_from_this();
  co_await connect(address);
  co_await shake_hands(address);
  asio::co_spawn(
      executor_, [self] { return self->read_all(); }, asio::detached);
  asio::co_spawn(
      executor_, [self] { return self->write_all(); }, asio::detached);
}

asio::awaitable<void> Connection::connect(Address address) {
  asio::ip::tcp::resolver resolver(executor_);
  const auto found =
      co_await resolver.async_resolve(address.host, address.port, asio::use_awaitable);
  error_code error = asio::error::host_not_found;
  for (const auto& entry : found) {
    auto& socket = stream_.next_layer();
    if (socket.is_open()) socket.close();
    socket.open(entry.endpoint().protocol());
    set_socket_options();
    co_await socket.async_connect(entry.endpoint(),
                                  asio::redirect_error(asio::use_awaitable, error));
    if (!error) co_return;
  }
  throw boost::system::system_error(error);
}

// Before connecting: the receive window is agreed on there.
void Connection::set_socket_options() {
  auto& socket = stream_.next_layer();
  socket.set_option(asio::ip::tcp::no_delay(true));
  if (link_.receive_buffer_bytes() == 0) return;
  socket.set_option(asio::socket_base::receive_buffer_size(link_.receive_buffer_bytes()));
  socket.set_option(SegmentSize(kSegmentBytes));
}

asio::awaitable<void> Connection::shake_hands(Address address) {
  stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::client));
  stream_.set_option(websocket::stream_base::decorator([](websocket::request_type& request) {
    request.set(beast::http::field::sec_websocket_protocol, kSubprotocol);
    request.set(beast::http::field::user_agent, "cutaway-load");
  }));
  stream_.read_message_max(kMessageBytes);
  stream_.auto_fragment(false);
  stream_.text(true);
  websocket::response_type response;
  error_code error;
  const std::string host = address.host + ":" + address.port;
  co_await stream_.async_handshake(response, host, address.path,
                                   asio::redirect_error(asio::use_awaitable, error));
  if (!error) co_return;
  // Its timer goes on otherwise, and with it the run.
  stream_.set_option(websocket::stream_base::timeout{websocket::stream_base::none(),
                                                     websocket::stream_base::none(), false});
  if (error == websocket::error::upgrade_declined)
    throw std::runtime_error(words_of(response, address));
  throw boost::system::system_error(error);
}

asio::awaitable<std::optional<Arrival>> Connection::receive() { return arriving_.pop(); }

void Connection::send(std::string text) {
  if (!ended_ && !closing_) leaving_.push(std::move(text), Clock::now() + link_.delay());
}

void Connection::stop_reading(TimePoint from, TimePoint until) {
  stop_from_ = from;
  stop_until_ = until;
}

asio::awaitable<void> Connection::read_all() {
  const auto self = shared_from_this();
  error_code error;
  while (!ended_) {
    const TimePoint now = Clock::now();
    if (now >= stop_from_ && now < stop_until_) co_await wait_until(stop_until_);
    const TimePoint asked = Clock::now();
    const std::size_t bytes = co_await stream_.async_read_some(
        incoming_, link_.chunk_bytes(), asio::redirect_error(asio::use_awaitable, error));
    if (error) break;
    const TimePoint transferred = link_.transferred(bytes, asked, Clock::now());
    if (stream_.is_message_done()) take_message(transferred);
    if (link_.limited()) co_await wait_until(transferred);
  }
  end(stream_.reason() ? "closed by the server with " + std::to_string(stream_.reason().code) +
                             " " + std::string(stream_.reason().reason.c_str())
                       : error.message());
}

void Connection::take_message(TimePoint transferred) {
  const asio::const_buffer content = incoming_.cdata();
  Arrival arrival{.text = stream_.got_text(),
                  .content = {static_cast<const char*>(content.data()), content.size()}};
  incoming_.consume(incoming_.size());
  arriving_.push(std::move(arrival), transferred + link_.delay());
}

asio::awaitable<void> Connection::write_all() {
  const auto self = shared_from_this();
  while (!ended_) {
    const std::optional<std::string> text = co_await leaving_.pop();
    if (!text) break;
    error_code error;
    co_await stream_.async_write(asio::buffer(*text),
                                 asio::redirect_error(asio::use_awaitable, error));
    if (error) break;  // the reader hears of it too, and says why
  }
}

asio::awaitable<void> Connection::wait_until(TimePoint time) {
  reading_timer_.expires_at(time);
  error_code woken;
  co_await reading_timer_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
}

void Connection::close() {
  if (closing_ || ended_) return;
  closing_ = true;
  leaving_.close();
  arriving_.close();
  const auto self = shared_from_this();
  asio::co_spawn(
      executor_, [self] { return self->cut_after_grace(); }, asio::detached);
  if (stream_.is_open()) {
    stream_.async_close(websocket::close_code::normal,
                        [self](const error_code&) { self->end({}); });
  }
}

asio::awaitable<void> Connection::cut_after_grace() {
  const auto self = shared_from_this();
  if (ended_) co_return;
  grace_timer_.expires_after(kGrace);
  error_code woken;
  co_await grace_timer_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
  end({});
}

void Connection::end(const std::string& reason) {
  if (ended_) return;
  ended_ = true;
  if (!closing_) end_reason_ = reason;
  error_code ignored;
  stream_.next_layer().close(ignored);
  leaving_.close();
  arriving_.finish();
  reading_timer_.cancel();
  grace_timer_.cancel();
}

}  // namespace cutaway::load
