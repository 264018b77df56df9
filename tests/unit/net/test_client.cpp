#include "unit/net/test_client.h"

#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <utility>

#include "scene/frame_header.h"

namespace cutaway::testing {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr std::chrono::seconds kGenerous{30};

tcp::endpoint endpoint(std::uint16_t port) {
  return {asio::ip::make_address_v4("127.0.0.1"), port};
}

/// Runs one asynchronous operation to its end; timed_out where that does not come.
template <typename Start>
error_code run_to_end(asio::io_context& io, Start start) {
  error_code result = asio::error::timed_out;
  start([&result](error_code error, auto&&...) { result = error; });
  io.restart();
  io.run_for(kGenerous);
  EXPECT_NE(result, asio::error::timed_out) << "nothing came in time";
  return result;
}

void bind_to(tcp::socket& socket, const std::string& from) {
  socket.open(tcp::v4());
  socket.bind({asio::ip::make_address(from), 0});
}

constexpr std::size_t kTextFrameBytes = 1024;

/// A masked text frame of 1 KiB (the mask is 0).
std::string text_frame(std::string text) {
  text.resize(kTextFrameBytes, ' ');
  const std::string header = {'\x81', '\xFE', static_cast<char>(kTextFrameBytes >> 8U),
                              static_cast<char>(kTextFrameBytes & 0xFFU)};
  return header + std::string(4, '\0') + text;
}

}  // namespace

RawClient::RawClient(std::uint16_t port, int receive_buffer_bytes, const std::string& from) {
  bind_to(socket_, from);
  if (receive_buffer_bytes > 0) {
    socket_.set_option(tcp::socket::receive_buffer_size(receive_buffer_bytes));
  }
  socket_.connect(endpoint(port));
}

bool RawClient::send(const std::string& bytes) {
  const error_code error = run_to_end(io_, [&](auto handler) {
    asio::async_write(socket_, asio::buffer(bytes), std::move(handler));
  });
  return !error;
}

std::optional<std::string> RawClient::read_to_end() {
  std::string received;
  const error_code error = run_to_end(io_, [&](auto handler) {
    asio::async_read(socket_, asio::dynamic_buffer(received), std::move(handler));
  });
  if (error == asio::error::timed_out) return std::nullopt;
  return received;
}

std::string RawClient::read_some() {
  std::string received(4096, '\0');
  std::size_t length = 0;
  run_to_end(io_, [&](auto handler) {
    socket_.async_read_some(asio::buffer(received),
                            [&length, handler](error_code error, std::size_t bytes) mutable {
                              length = bytes;
                              handler(error);
                            });
  });
  received.resize(length);
  return received;
}

bool RawClient::flood_until_closed() {
  const std::string frame = text_frame("nonsense");
  const auto limit = std::chrono::steady_clock::now() + kGenerous;
  while (std::chrono::steady_clock::now() < limit) {
    if (!send(frame)) return true;
  }
  return false;
}

bool RawClient::send_text_frame(std::string text) { return send(text_frame(std::move(text))); }

void RawClient::reset() {
  socket_.set_option(tcp::socket::linger(true, 0));
  socket_.close();
}

void RawClient::upgrade() {
  send(
      "GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Protocol: cutaway.v1\r\n\r\n");
  std::string received = read_some();
  EXPECT_TRUE(received.starts_with("HTTP/1.1 101 "));
  while (received.find("capabilities") == std::string::npos) {
    const std::string more = read_some();
    if (more.empty()) break;
    received += more;
  }
}

HttpResponseMessage fetch(std::uint16_t port, const std::string& target,
                          const std::vector<std::pair<std::string, std::string>>& headers,
                          const std::string& method) {
  asio::io_context io;
  tcp::socket socket(io);
  socket.connect(endpoint(port));
  http::request<http::string_body> request;
  request.version(11);
  request.method_string(method);
  request.target(target);
  request.set(http::field::host, "127.0.0.1");
  for (const auto& [name, value] : headers) request.set(name, value);
  request.prepare_payload();
  http::write(socket, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.skip(method == "HEAD");
  run_to_end(io, [&](auto handler) { http::async_read(socket, buffer, parser, handler); });
  return parser.release();
}

template <typename Start>
error_code SocketClient::finish(Start start) {
  return run_to_end(io_, std::move(start));
}

SocketClient::SocketClient(std::uint16_t port, const Options& options) {
  bind_to(beast::get_lowest_layer(stream_).socket(), options.from);
  beast::get_lowest_layer(stream_).connect(endpoint(port));
  stream_.set_option(websocket::stream_base::decorator([options](websocket::request_type& request) {
    if (!options.subprotocol.empty()) {
      request.set(http::field::sec_websocket_protocol, options.subprotocol);
    }
    if (!options.forwarded_for.empty()) request.set("X-Forwarded-For", options.forwarded_for);
    if (!options.origin.empty()) request.set(http::field::origin, options.origin);
  }));
  stream_.read_message_max(64U << 20U);
  const std::string host = "127.0.0.1:" + std::to_string(port);
  finish([&](auto handler) {
    stream_.async_handshake(handshake_, host, options.target, std::move(handler));
  });
}

void SocketClient::send_text(const std::string& text) {
  stream_.text(true);
  finish([&](auto handler) { stream_.async_write(asio::buffer(text), std::move(handler)); });
}

void SocketClient::send_binary(const std::string& bytes) {
  stream_.binary(true);
  finish([&](auto handler) { stream_.async_write(asio::buffer(bytes), std::move(handler)); });
}

std::optional<SocketClient::Message> SocketClient::read() {
  incoming_.clear();
  const error_code error =
      finish([&](auto handler) { stream_.async_read(incoming_, std::move(handler)); });
  if (error) return std::nullopt;
  const auto* begin = static_cast<const char*>(incoming_.data().data());
  if (stream_.got_text()) return Json::parse(begin, begin + incoming_.size());
  return Binary{{begin, begin + incoming_.size()}};
}

Json SocketClient::read_until(const std::string& type) {
  while (const auto message = read()) {
    if (const auto* frame = std::get_if<Binary>(&*message)) {
      acknowledge(*frame);
    } else if (std::get<Json>(*message)["type"] == type) {
      return std::get<Json>(*message);
    }
  }
  return {};
}

std::optional<SocketClient::Binary> SocketClient::read_frame() {
  while (auto message = read()) {
    if (auto* frame = std::get_if<Binary>(&*message)) return std::move(*frame);
  }
  return std::nullopt;
}

std::uint16_t SocketClient::read_close_code() {
  while (read()) {
  }
  return stream_.reason().code;
}

void SocketClient::acknowledge(const Binary& frame) {
  send({{"type", "ack"}, {"frame", decode_frame(frame.bytes).header.frame}});
}

void SocketClient::show_ball() {
  send({{"type", "viewport"},
        {"input", ++input_},
        {"clock_ms", 1.5},
        {"width_px", 64},
        {"height_px", 48}});
  send(
      {{"type", "scene"}, {"input", ++input_}, {"clock_ms", 2.5}, {"scene", {{"volume", "ball"}}}});
}

void SocketClient::move_lens(double radius_mm) {
  send({{"type", "scene"},
        {"input", ++input_},
        {"clock_ms", 3.5},
        {"scene", {{"lens", {{"radius_mm", radius_mm}}}}}});
}

}  // namespace cutaway::testing
