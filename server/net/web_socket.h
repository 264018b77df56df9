// One client's WebSocket: its reads, its writes, its session.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "net/admission.h"
#include "net/asio_strand.h"
#include "net/awaitable.h"
#include "net/drop_log.h"
#include "net/http_answers.h"
#include "net/out_queue.h"
#include "net/settings.h"
#include "session/session.h"
#include "session/token_bucket.h"

namespace cutaway {

/// `name` is the session's, for the log.
using SessionFactory = std::function<std::unique_ptr<Session>(
    const std::string& name, std::shared_ptr<Strand> strand, ClientSink& client)>;

/// Everything runs on the strand that the stream was accepted on. One read is always pending, one
/// write at a time is; a write that the client does not take within its deadline, or texts that
/// pile up, end the connection. So does an exception of the session, with 1011: nobody else's is
/// touched.
class WebSocket final : public ClientSink, public std::enable_shared_from_this<WebSocket> {
 public:
  struct Peer {
    ClientAddress address;
    std::uint64_t number = 0;  ///< of this socket, for the log
  };

  WebSocket(boost::beast::tcp_stream&& stream, const AsioStrand::Executor& strand,
            const NetSettings& settings, SessionFactory make_session, Peer peer);

  /// Completes the upgrade and serves the session until the connection ends. Where no seat is free
  /// the client is told its place in the queue until one is; where that is full, too, it is told
  /// so, and the connection closed with 1013. With 4000, where it gives its seat to another. Throws
  /// nothing.
  boost::asio::awaitable<void> serve(HttpRequest request, Admission& admission, DropLog& drops);

  /// Begins a closing handshake that says "going away". On the strand.
  void close();
  /// Ends the connection at once. On the strand.
  void abort();

  void send_text(std::string message) override;
  void send_latest_text(std::string message) override;
  void send_frame(ViewKind view, std::vector<std::uint8_t> message,
                  std::function<void(bool)> done) override;
  void send_still(std::vector<std::uint8_t> message, std::function<void(bool)> done) override;

 private:
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream, false>;

  boost::asio::awaitable<bool> accept(HttpRequest request);
  std::optional<Admission::Refusal> queue_up(Admission& admission);
  Admission::Guest guest();
  void moved_to(int place);
  void give_way(Admission::Why why);
  void start_session();
  boost::asio::awaitable<void> serve_accepted();
  void turn_away(Admission::Refusal refusal, DropLog& drops);
  void control_frame(boost::beast::websocket::frame_type kind);
  boost::asio::awaitable<void> read_all();
  boost::asio::awaitable<bool> read_message();
  boost::asio::awaitable<void> write_all();
  boost::asio::awaitable<bool> write(const OutQueue::Message& message);
  boost::asio::awaitable<void> wait_for_messages();
  boost::asio::awaitable<void> take_breath();
  Session::Reception deliver();
  Session::Reception pass_over();
  Session::Reception hand_to_session();
  bool takes_words() const { return !closing_ && !ended_ && !last_words_; }
  void was_put(bool put);
  void begin_close(const boost::beast::websocket::close_reason& reason);
  void start_write_deadline(std::size_t still_bytes);
  void stop_write_deadline();
  void end_with(const Error& words, const boost::beast::websocket::close_reason& reason);
  void fail(const char* what);
  void end();

  Stream stream_;
  AsioStrand::Executor executor_;
  NetSettings settings_;
  SessionFactory make_session_;
  OutQueue queue_;
  boost::beast::flat_buffer incoming_;
  std::size_t incoming_bytes_ = 0;  ///< of the message, those dropped included
  boost::asio::steady_timer something_to_write_;
  boost::asio::steady_timer write_deadline_;
  boost::asio::steady_timer breather_;
  TokenBucket unheard_;  ///< messages that come while there is no session to hear them
  Peer peer_;
  std::string name_;  ///< in the log
  std::unique_ptr<Admission::Ticket> ticket_;
  std::unique_ptr<Session> session_;
  std::optional<boost::beast::websocket::close_reason> last_words_;  ///< once the queue is empty
  std::uint64_t deadline_ =
      0;  ///< counts settings of write_deadline_, so that a late one is known as void
  bool closing_ = false;
  bool ended_ = false;
};

}  // namespace cutaway
