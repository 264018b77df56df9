#include "net/web_socket.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "core/log.h"
#include "net/http_headers.h"
#include "net/upgrade.h"
#include "scene/json_text.h"
#include "scene/server_message.h"

namespace cutaway {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;

namespace {

constexpr std::size_t kMessageReadBytes = std::size_t{16} * 1024;
constexpr std::chrono::milliseconds kBreath{20};  // no reading for so long after too many messages

constexpr std::size_t kLargestPiece = std::size_t{4} << 20;
/// What a client that takes a large message has to take of it.
constexpr std::size_t kSlowestBytesPerSecond = std::size_t{128} << 10;

asio::const_buffer buffer_of(const OutQueue::Message& message) {
  return std::visit([](const auto& content) -> asio::const_buffer { return asio::buffer(content); },
                    message.content);
}

/// Of those that RFC 6455 (7.4.2) leaves to applications: the session went to another who waited.
constexpr std::uint16_t kGaveWay = 4000;
/// From here on close codes mean nothing (7.4.2); Beast, which knows the others that do not, takes
/// these.
constexpr std::uint16_t kFirstNoCode = 5000;

std::string server_full(const NetSettings& settings) {
  return fmt::format("all {} sessions are taken and {} clients wait for one; try again later",
                     settings.sessions, settings.queued_sessions);
}

std::string address_full(const NetSettings& settings) {
  return fmt::format("your address has {} sessions, which are all that it may have",
                     settings.sessions_per_address);
}

std::string words_for(Admission::Why why, const NetSettings& settings) {
  switch (why) {
    case Admission::Why::idle:
      return "the session was not used while others waited, and went to one of them";
    case Admission::Why::over_share:
      return "others waited and your address had more than its share; the session went to them";
    case Admission::Why::queue_full:
      return server_full(settings);
  }
  return {};
}

bool is_ordinary_end(const error_code& error) {
  return error == websocket::error::closed || error == asio::error::operation_aborted ||
         error == asio::error::eof || error == asio::error::connection_reset;
}

}  // namespace

WebSocket::WebSocket(beast::tcp_stream&& stream, const AsioStrand::Executor& strand,
                     const NetSettings& settings, SessionFactory make_session, Peer peer)
    : stream_(std::move(stream)),
      executor_(strand),
      settings_(settings),
      make_session_(std::move(make_session)),
      queue_(settings.queued_text_bytes),
      something_to_write_(strand, asio::steady_timer::time_point::max()),
      write_deadline_(strand),
      breather_(strand),
      unheard_(settings.messages, std::chrono::steady_clock::now()),
      peer_(std::move(peer)),
      name_(fmt::format("session {} of {}", peer_.number, peer_.address.text)) {}

asio::awaitable<bool> WebSocket::accept(HttpRequest request) {
  beast::get_lowest_layer(stream_).expires_never();
  stream_.set_option(websocket::stream_base::timeout{.handshake_timeout = settings_.request_timeout,
                                                     .idle_timeout = settings_.idle_timeout,
                                                     .keep_alive_pings = true});
  stream_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    set_security_headers(response);
    response.set(beast::http::field::sec_websocket_protocol, kSubprotocol);
  }));
  stream_.read_message_max(std::max(settings_.message_bytes, settings_.dropped_message_bytes));
  stream_.write_buffer_bytes(kLargestPiece);
  stream_.control_callback(
      [this](websocket::frame_type kind, beast::string_view) { control_frame(kind); });
  error_code error;
  co_await stream_.async_accept(request, asio::redirect_error(asio::use_awaitable, error));
  co_return !error;
}

asio::awaitable<void> WebSocket::serve(HttpRequest request, Admission& admission, DropLog& drops) {
  const auto self = shared_from_this();
  const bool accepted = co_await accept(std::move(request));
  if (!accepted) co_return;
  const std::optional<Admission::Refusal> refusal = queue_up(admission);
  if (refusal) turn_away(*refusal, drops);
  co_await serve_accepted();
}

std::optional<Admission::Refusal> WebSocket::queue_up(Admission& admission) {
  auto entered = admission.enter(peer_.address, guest(), std::chrono::steady_clock::now());
  if (const auto* refusal = std::get_if<Admission::Refusal>(&entered)) return *refusal;
  ticket_ = std::move(std::get<std::unique_ptr<Admission::Ticket>>(entered));
  return std::nullopt;
}

Admission::Guest WebSocket::guest() {
  const auto on_strand = [weak = weak_from_this(), executor = executor_](auto member) {
    return [weak, executor, member](auto what) {
      asio::post(executor, [weak, member, what] {
        if (const auto self = weak.lock()) (self.get()->*member)(what);
      });
    };
  };
  return {.moved = on_strand(&WebSocket::moved_to), .gives_way = on_strand(&WebSocket::give_way)};
}

void WebSocket::moved_to(int place) {
  if (!takes_words()) return;
  if (place == 0) return start_session();
  send_latest_text(json_text(queued_message(place)));
}

// The seat is another's already: what the session holds is let go at once, however long the goodbye
// takes.
void WebSocket::give_way(Admission::Why why) {
  if (!takes_words()) return;
  const std::string words = words_for(why, settings_);
  log().info("{} gives way: {}", name_, words);
  const bool was_queued = why == Admission::Why::queue_full;
  const std::uint16_t code =
      was_queued ? std::uint16_t{websocket::close_code::try_again_later} : kGaveWay;
  end_with(
      Error({.code = was_queued ? ErrorCode::server_full : ErrorCode::gave_way, .message = words}),
      {static_cast<websocket::close_code>(code), words});
}

asio::awaitable<void> WebSocket::serve_accepted() {
  const auto self = shared_from_this();
  asio::co_spawn(
      executor_, [self] { return self->write_all(); },
      [self](const std::exception_ptr& failure) {
        if (failure) self->abort();
      });
  try {
    co_await read_all();
  } catch (const std::exception& failure) {
    log().error("{}: reading failed: {}", name_, failure.what());
  }
  end();
}

void WebSocket::start_session() {
  try {
    session_ =
        make_session_(name_,
                      std::make_shared<AsioStrand>(executor_,
                                                   [weak = weak_from_this()](const char* what) {
                                                     if (const auto self = weak.lock())
                                                       self->fail(what);
                                                   }),
                      *this);
    session_->start();
  } catch (const std::exception& failure) {
    fail(failure.what());
  }
}

void WebSocket::turn_away(Admission::Refusal refusal, DropLog& drops) {
  const bool is_full = refusal == Admission::Refusal::full;
  const std::string reason = is_full ? server_full(settings_) : address_full(settings_);
  drops.note("clients were turned away, " + reason, peer_.address.text);
  end_with(Error({.code = ErrorCode::server_full, .message = reason}),
           {websocket::close_code::try_again_later, reason});
}

// A closing handshake that has begun here is not answered with the code that came.
void WebSocket::control_frame(websocket::frame_type kind) {
  if (kind != websocket::frame_type::close || stream_.reason().code < kFirstNoCode) return;
  begin_close({websocket::close_code::protocol_error, "there is no such close code"});
}

asio::awaitable<void> WebSocket::read_all() {
  bool open = co_await read_message();
  while (open) {
    const Session::Reception reception = deliver();
    if (reception == Session::Reception::too_fast) co_await take_breath();
    open = co_await read_message();
  }
}

// What exceeds the limit is dropped as it comes, so that one long message costs no memory and can
// be answered. False where the connection has ended.
asio::awaitable<bool> WebSocket::read_message() {
  incoming_.clear();
  incoming_bytes_ = 0;
  do {
    error_code error;
    const std::size_t bytes = co_await stream_.async_read_some(
        incoming_, kMessageReadBytes, asio::redirect_error(asio::use_awaitable, error));
    incoming_bytes_ += bytes;
    if (error) {
      if (!is_ordinary_end(error)) log().info("{} ended: {}", name_, error.message());
      co_return false;
    }
    if (incoming_bytes_ > settings_.message_bytes) incoming_.clear();
  } while (!stream_.is_message_done());
  co_return true;
}

Session::Reception WebSocket::deliver() {
  if (!session_) return pass_over();
  try {
    const Session::Reception reception = hand_to_session();
    if (ticket_) ticket_->heard(session_->page_visible(), std::chrono::steady_clock::now());
    return reception;
  } catch (const std::exception& failure) {
    fail(failure.what());
    return Session::Reception::taken;
  }
}

// It waits for a seat, or has failed and the closing handshake goes on.
Session::Reception WebSocket::pass_over() {
  return unheard_.take(std::chrono::steady_clock::now()) ? Session::Reception::taken
                                                         : Session::Reception::too_fast;
}

Session::Reception WebSocket::hand_to_session() {
  if (incoming_bytes_ > settings_.message_bytes) {
    return session_->receive_too_large(incoming_bytes_, settings_.message_bytes);
  }
  if (!stream_.got_text()) return session_->receive_binary();
  const asio::const_buffer text = incoming_.cdata();
  return session_->receive_text({static_cast<const char*>(text.data()), text.size()});
}

// Who sends too much is read from more slowly: the network pushes back, and the others keep their
// share.
asio::awaitable<void> WebSocket::take_breath() {
  error_code error;
  breather_.expires_after(kBreath);
  co_await breather_.async_wait(asio::redirect_error(asio::use_awaitable, error));
}

asio::awaitable<void> WebSocket::write_all() {
  bool writable = true;
  while (writable && !ended_) {
    const std::optional<OutQueue::Message> message = queue_.take();
    if (!message && last_words_) begin_close(*std::exchange(last_words_, std::nullopt));
    if (!message) {
      co_await wait_for_messages();
      continue;
    }
    writable = co_await write(*message);
    if (message->done) message->done(writable);
  }
  queue_.abandon();
  if (!closing_) abort();
}

asio::awaitable<bool> WebSocket::write(const OutQueue::Message& message) {
  error_code error;
  const asio::const_buffer buffer = buffer_of(message);
  start_write_deadline(message.is_still ? buffer.size() : 0);
  // In pieces, between which pings are answered: a still for print takes minutes on a slow link.
  stream_.auto_fragment(buffer.size() > kLargestPiece);
  stream_.text(std::holds_alternative<std::string>(message.content));
  co_await stream_.async_write(buffer, asio::redirect_error(asio::use_awaitable, error));
  stop_write_deadline();
  co_return !error;
}

asio::awaitable<void> WebSocket::wait_for_messages() {
  error_code woken;
  co_await something_to_write_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
}

void WebSocket::start_write_deadline(std::size_t still_bytes) {
  const std::chrono::milliseconds for_its_size(1000 * still_bytes / kSlowestBytesPerSecond);
  write_deadline_.expires_after(settings_.write_timeout + for_its_size);
  write_deadline_.async_wait(
      [self = shared_from_this(), setting = ++deadline_](const error_code& error) {
        if (error || setting != self->deadline_) return;
        log().info("{} did not take a message in time and is dropped", self->name_);
        self->abort();
      });
}

void WebSocket::stop_write_deadline() {
  ++deadline_;
  write_deadline_.cancel();
}

void WebSocket::send_text(std::string message) {
  if (takes_words()) was_put(queue_.put_text(std::move(message)));
}

void WebSocket::send_latest_text(std::string message) {
  if (takes_words()) was_put(queue_.put_latest_text(std::move(message)));
}

void WebSocket::was_put(bool put) {
  if (put) {
    something_to_write_.cancel();
    return;
  }
  log().info("{} leaves too much unread and is closed", name_);
  begin_close({websocket::close_code::policy_error, "too many messages wait to be read"});
}

void WebSocket::send_frame(ViewKind view, std::vector<std::uint8_t> message,
                           std::function<void(bool)> done) {
  if (!takes_words()) return done(false);
  queue_.put_frame(static_cast<int>(view), std::move(message), std::move(done));
  something_to_write_.cancel();
}

void WebSocket::send_still(std::vector<std::uint8_t> message, std::function<void(bool)> done) {
  if (!takes_words()) return done(false);
  queue_.put_still(std::move(message), std::move(done));
  something_to_write_.cancel();
}

void WebSocket::close() { begin_close({websocket::close_code::going_away, "the server stops"}); }

void WebSocket::begin_close(const websocket::close_reason& reason) {
  if (closing_ || !stream_.is_open()) return;
  closing_ = true;
  stream_.async_close(reason, [self = shared_from_this()](const error_code&) {});
}

// As begin_close, once the client has been told why in words of the protocol.
void WebSocket::end_with(const Error& words, const websocket::close_reason& reason) {
  session_.reset();
  queue_.abandon();
  send_text(json_text(error_message(words)));
  last_words_ = reason;
}

// The session may be in any state now: it goes, and the client hears why in the closing handshake.
void WebSocket::fail(const char* what) {
  log().error("{} failed and is closed: {}", name_, what);
  session_.reset();
  begin_close({websocket::close_code::internal_error, "the server failed at this session"});
}

void WebSocket::abort() {
  beast::get_lowest_layer(stream_).close();
  breather_.cancel();
}

void WebSocket::end() {
  ended_ = true;
  abort();
  queue_.abandon();
  something_to_write_.cancel();
  session_.reset();
  ticket_.reset();
}

}  // namespace cutaway
