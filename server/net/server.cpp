#include "net/server.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <thread>
#include <utility>
#include <vector>

#include "core/log.h"
#include "core/threads.h"
#include "net/host_check.h"
#include "net/http_connection.h"

namespace cutaway {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::chrono::milliseconds kPauseAfterFailedAccept{100};
constexpr std::chrono::seconds kBetweenOrders{1};

Error cannot_listen(const NetSettings& settings, const std::string& why) {
  return Error({.code = ErrorCode::internal,
                .message = "cannot listen: " + why,
                .field = settings.address + ":" + std::to_string(settings.port),
                .expected = "a free port on an address of this machine"});
}

asio::ip::address peer_of(const tcp::socket& socket) {
  error_code none;
  return socket.remote_endpoint(none).address();
}

void log_failure(const asio::ip::address& peer, const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    log().error("a connection of {} failed: {}", peer.to_string(), error.what());
  }
}

Admission::Limits admission_limits(const NetSettings& settings) {
  return {.seats = settings.sessions,
          .queue = settings.queued_sessions,
          .per_address = settings.sessions_per_address,
          .idle_seat = settings.idle_seat,
          .share_wait = settings.share_wait};
}

void warn_of_names(const NetSettings& settings) {
  if (is_loopback_address(settings.address) || !settings.hosts.empty()) return;
  log().warn("only requests to an IP address are answered: server.hosts names no host");
}

tcp::endpoint endpoint_of(const NetSettings& settings) {
  error_code error;
  const asio::ip::address address = asio::ip::make_address(settings.address, error);
  if (error) throw cannot_listen(settings, "this is no IP address");
  return {address, settings.port};
}

}  // namespace

class Server::Impl {
 public:
  Impl(const NetSettings& settings, Hooks hooks);

  std::string url() const;
  void run(const std::function<void()>& on_ready);
  void stop();

 private:
  void listen();
  void watch_signals();
  asio::awaitable<void> accept_all();
  void work() noexcept;
  asio::awaitable<void> keep_order();
  HttpAnswers::Sources with_fullness(HttpAnswers::Sources sources);
  void begin_connection(tcp::socket&& socket, const AsioStrand::Executor& strand);
  void end_all();
  void all_ended();

  asio::io_context io_;
  AsioStrand::Executor strand_{asio::make_strand(io_)};  // of the acceptor and of stopping
  ConnectionContext context_;
  tcp::acceptor acceptor_{strand_};
  asio::signal_set signals_{strand_};
  asio::steady_timer accept_pause_{strand_};
  asio::steady_timer order_timer_{strand_};
  asio::steady_timer stop_deadline_{strand_};
  bool stopping_ = false;
};

Server::Impl::Impl(const NetSettings& settings, Hooks hooks)
    : context_{.settings = settings,
               .admission = Admission(admission_limits(settings)),
               .answers = HttpAnswers(
                   settings.web_root.empty() ? StaticFiles() : StaticFiles(settings.web_root),
                   with_fullness(std::move(hooks.sources))),
               .make_session = std::move(hooks.make_session)} {
  listen();
  warn_of_names(settings);
  asio::co_spawn(
      strand_, [this] { return accept_all(); }, asio::detached);
  asio::co_spawn(
      strand_, [this] { return keep_order(); }, asio::detached);
}

HttpAnswers::Sources Server::Impl::with_fullness(HttpAnswers::Sources sources) {
  sources.full = [this] { return context_.admission.is_full(); };
  return sources;
}

void Server::Impl::listen() {
  const tcp::endpoint endpoint = endpoint_of(context_.settings);
  try {
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  } catch (const boost::system::system_error& failure) {
    throw cannot_listen(context_.settings, failure.code().message());
  }
}

std::string Server::Impl::url() const {
  std::ostringstream text;
  text << "http://" << acceptor_.local_endpoint() << "/";
  return text.str();
}

void Server::Impl::run(const std::function<void()>& on_ready) {
  watch_signals();
  std::vector<std::jthread> threads;
  try {
    for (int i = 1; i < context_.settings.io_threads; ++i) {
      threads.push_back(start_thread([this](const std::stop_token&) { work(); }));
    }
  } catch (...) {
    io_.stop();  // those that were started are waited for
    throw;
  }
  if (on_ready) on_ready();
  work();
}

void Server::Impl::watch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) signals_.add(signal);
  signals_.async_wait([this](const error_code& error, int) {
    if (!error) end_all();
  });
}

// What a handler lets out ends that handler alone.
void Server::Impl::work() noexcept {
  while (true) {
    try {
      io_.run();
      return;
    } catch (const std::exception& failure) {
      log().error("a handler of the network failed: {}", failure.what());
    }
  }
}

asio::awaitable<void> Server::Impl::accept_all() {
  while (!stopping_) {
    const AsioStrand::Executor strand = asio::make_strand(io_);
    tcp::socket socket(strand);
    error_code error;
    co_await acceptor_.async_accept(socket, asio::redirect_error(asio::use_awaitable, error));
    if (stopping_) break;
    if (!error) {
      begin_connection(std::move(socket), strand);
      continue;
    }
    log().warn("a connection could not be accepted: {}", error.message());
    accept_pause_.expires_after(kPauseAfterFailedAccept);
    co_await accept_pause_.async_wait(asio::redirect_error(asio::use_awaitable, error));
  }
}

// What time alone brings about.
asio::awaitable<void> Server::Impl::keep_order() {
  while (!stopping_) {
    order_timer_.expires_after(kBetweenOrders);
    error_code error;
    co_await order_timer_.async_wait(asio::redirect_error(asio::use_awaitable, error));
    context_.admission.make_room(std::chrono::steady_clock::now());
    context_.drops.flush();
  }
}

void Server::Impl::begin_connection(tcp::socket&& socket, const AsioStrand::Executor& strand) {
  const asio::ip::address peer = peer_of(socket);
  try {
    auto connection = std::make_shared<HttpConnection>(std::move(socket), strand, context_);
    if (!connection->enter()) return;
    asio::co_spawn(
        strand, [connection] { return connection->run(); },
        [this, peer](const std::exception_ptr& failure) {
          if (failure) log_failure(peer, failure);
          asio::post(strand_, [this] { all_ended(); });
        });
  } catch (const std::exception& failure) {
    log().error("a connection of {} could not be begun: {}", peer.to_string(), failure.what());
  }
}

void Server::Impl::stop() {
  asio::post(strand_, [this] { end_all(); });
}

void Server::Impl::end_all() {
  if (stopping_) return;
  stopping_ = true;
  log().info("stopping");
  error_code ignored;
  acceptor_.close(ignored);
  signals_.cancel(ignored);
  signals_.clear(ignored);  // the next does what signals do by themselves
  accept_pause_.cancel();
  order_timer_.cancel();
  context_.connections.for_each([](OpenConnection& connection) { connection.close(); });
  stop_deadline_.expires_after(context_.settings.stop_timeout);
  stop_deadline_.async_wait([this](const error_code& error) {
    if (error) return;
    context_.connections.for_each([](OpenConnection& connection) { connection.abort(); });
  });
  all_ended();
}

void Server::Impl::all_ended() {
  if (stopping_ && context_.connections.size() == 0) stop_deadline_.cancel();
}

Server::Server(const NetSettings& settings, Hooks hooks)
    : impl_(std::make_unique<Impl>(settings, std::move(hooks))) {}

Server::~Server() = default;

std::string Server::url() const { return impl_->url(); }
void Server::run(const std::function<void()>& on_ready) { impl_->run(on_ready); }
void Server::stop() { impl_->stop(); }

}  // namespace cutaway
