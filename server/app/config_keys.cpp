#include "app/config_keys.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "net/client_address.h"
#include "net/request_head.h"
#include "scene/client_message.h"

namespace cutaway {

namespace {

constexpr std::int64_t kMillion = 1'000'000;
constexpr std::int64_t kTera = std::int64_t{1} << 40;

template <typename Field>
IntegerKey integer(std::int64_t minimum, std::int64_t maximum, Field field) {
  return {minimum, maximum, [field](Config& config, std::int64_t value) {
            auto& place = field(config);
            place = static_cast<std::remove_reference_t<decltype(place)>>(value);
          }};
}

template <typename Field>
IntegerKey milliseconds(std::int64_t minimum, std::int64_t maximum, Field field) {
  return {minimum, maximum, [field](Config& config, std::int64_t value) {
            field(config) = std::chrono::milliseconds(value);
          }};
}

template <typename Kind, typename Field>
Kind plain(Field field) {
  return {[field](Config& config, const auto& value) { field(config) = value; }};
}

// A client has one rate, whether it has a session or waits for one.
void set_message_rate(Config& config, double MessageRate::*part, double value) {
  config.session.messages.*part = value;
  config.net.messages.*part = value;
}

void set_log_level(Config& config, const std::string& level) {
  constexpr std::array kLevels = {"trace", "debug", "info", "warning", "error", "off"};
  if (std::ranges::find(kLevels, level) == kLevels.end()) {
    throw Error({.code = ErrorCode::out_of_range,
                 .message = "there is no such log level",
                 .expected = "trace, debug, info, warning, error or off",
                 .received = level});
  }
  config.log_level = level;
}

void set_hosts(Config& config, const std::vector<std::string>& hosts) {
  for (const std::string& host : hosts) {
    const bool has_port = !host.starts_with('[') && host.find(':') != std::string::npos;
    if (!host.empty() && !has_port && !host.ends_with(':') && is_host_and_port(host)) continue;
    throw Error({.code = ErrorCode::wrong_type,
                 .message = "this is no host",
                 .expected = "a name or an address, without a scheme and a port",
                 .received = host});
  }
  config.net.hosts = hosts;
}

void set_trusted_proxies(Config& config, const std::vector<std::string>& proxies) {
  static_cast<void>(TrustedProxies(proxies));  // refuses what is none
  config.net.trusted_proxies = proxies;
}

/// Who may come, and how many.
std::vector<ConfigKey> seat_keys() {
  return {
      {"server", "connections",
       integer(
           1, kMillion, [](Config & c) -> auto& { return c.net.connections; })},
      {"server", "connections_per_address",
       integer(
           0, kMillion, [](Config & c) -> auto& { return c.net.connections_per_address; })},
      {"server", "sessions",
       integer(
           1, kMillion, [](Config & c) -> auto& { return c.net.sessions; })},
      {"server", "queued_sessions",
       integer(
           0, kMillion, [](Config & c) -> auto& { return c.net.queued_sessions; })},
      {"server", "sessions_per_address",
       integer(
           0, kMillion, [](Config & c) -> auto& { return c.net.sessions_per_address; })},
      {"server", "limit_loopback",
       plain<BooleanKey>([](Config & c) -> auto& { return c.net.limit_loopback; })},
      {"server", "idle_seat_ms",
       milliseconds(
           0, 100 * kMillion, [](Config & c) -> auto& { return c.net.idle_seat; })},
      {"server", "share_wait_ms",
       milliseconds(
           0, 100 * kMillion, [](Config & c) -> auto& { return c.net.share_wait; })},
  };
}

std::vector<ConfigKey> server_keys() {
  return {
      {"server", "listen",
       TextKey{[](Config& c, const std::string& t) { parse_listen(t, c.net); }}},
      {"server", "io_threads",
       integer(
           1, 64, [](Config & c) -> auto& { return c.net.io_threads; })},
      {"server", "message_bytes",
       integer(
           1024, 64 * kMillion, [](Config & c) -> auto& { return c.net.message_bytes; })},
      {"server", "dropped_message_bytes",
       integer(
           1024, 1 << 30, [](Config & c) -> auto& { return c.net.dropped_message_bytes; })},
      {"server", "queued_text_bytes",
       integer(
           std::int64_t{64} * 1024, kTera,
           [](Config & c) -> auto& { return c.net.queued_text_bytes; })},
      {"server", "send_buffer_bytes",
       integer(
           0, 1 << 30, [](Config & c) -> auto& { return c.net.send_buffer_bytes; })},
      {"server", "request_timeout_ms",
       milliseconds(
           10, kMillion, [](Config & c) -> auto& { return c.net.request_timeout; })},
      {"server", "idle_timeout_ms",
       milliseconds(
           100, 100 * kMillion, [](Config & c) -> auto& { return c.net.idle_timeout; })},
      {"server", "write_timeout_ms",
       milliseconds(
           10, kMillion, [](Config & c) -> auto& { return c.net.write_timeout; })},
      {"server", "stop_timeout_ms",
       milliseconds(
           0, kMillion, [](Config & c) -> auto& { return c.net.stop_timeout; })},
      {"server", "allowed_origins",
       plain<TextListKey>([](Config & c) -> auto& { return c.net.allowed_origins; })},
      {"server", "hosts", TextListKey{set_hosts}},
      {"server", "trusted_proxies", TextListKey{set_trusted_proxies}},
      {"server", "web_root", plain<PathKey>([](Config & c) -> auto& { return c.net.web_root; })},
      {"server", "notice", plain<TextKey>([](Config & c) -> auto& { return c.notice; })},
  };
}

std::vector<ConfigKey> session_keys() {
  return {
      {"session", "frames_in_flight",
       integer(
           1, 8, [](Config & c) -> auto& { return c.session.frames_in_flight; })},
      {"session", "frame_budget_ms",
       NumberKey{1, 1000, [](Config& c, double v) { c.session.frame_budget = Milliseconds(v); }}},
      {"session", "first_resolution_scale",
       NumberKey{0.25, 1, [](Config& c, double v) { c.session.first_resolution_scale = v; }}},
      {"session", "rest_ms",
       NumberKey{0, 60'000, [](Config& c, double v) { c.session.rest = Milliseconds(v); }}},
      {"session", "still_jpeg_quality",
       integer(
           1, 100, [](Config & c) -> auto& { return c.session.still_jpeg_quality; })},
      {"session", "still_supersampling",
       integer(
           1, 2, [](Config & c) -> auto& { return c.session.still_supersampling; })},
      {"session", "still_rays",
       integer(
           1, kTera, [](Config & c) -> auto& { return c.session.still_rays; })},
      {"session", "still_budget_ms",
       NumberKey{0, 60'000, [](Config& c, double v) { c.session.still_budget = Milliseconds(v); }}},
      {"session", "still_side_px",
       integer(
           1, kLargestSide_px, [](Config & c) -> auto& { return c.session.still_side_px; })},
      {"session", "viewport_side_px",
       integer(
           1, kLargestSide_px, [](Config & c) -> auto& { return c.session.viewport_side_px; })},
      {"session", "viewport_pixels",
       integer(
           0, std::int64_t{kLargestSide_px} * kLargestSide_px,
           [](Config & c) -> auto& { return c.session.viewport_pixels; })},
      {"session", "messages_per_second",
       NumberKey{1, 1e6,
                 [](Config& c, double v) { set_message_rate(c, &MessageRate::per_second, v); }}},
      {"session", "message_burst",
       NumberKey{1, 1e6, [](Config& c, double v) { set_message_rate(c, &MessageRate::burst, v); }}},
      {"session", "lens_search_messages",
       NumberKey{0, 1e6, [](Config& c, double v) { c.session.lens_search_messages = v; }}},
  };
}

std::vector<ConfigKey> other_keys() {
  return {
      {"volumes", "data", plain<PathListKey>([](Config & c) -> auto& { return c.volumes.data; })},
      {"volumes", "volume_bytes",
       integer(
           kMillion, 1024 * kTera, [](Config & c) -> auto& { return c.volumes.volume_bytes; })},
      {"volumes", "memory_bytes",
       integer(
           0, 1024 * kTera, [](Config & c) -> auto& { return c.volumes.memory_bytes; })},
      {"volumes", "load_threads",
       integer(
           1, 64, [](Config & c) -> auto& { return c.volumes.load_threads; })},
      {"renderer", "require_gpu",
       plain<BooleanKey>([](Config & c) -> auto& { return c.renderer.require_gpu; })},
      {"renderer", "volume_bytes",
       integer(
           0, 1024 * kTera, [](Config & c) -> auto& { return c.renderer.limits.volume_bytes; })},
      {"renderer", "view_bytes",
       integer(
           0, 1024 * kTera, [](Config & c) -> auto& { return c.renderer.limits.view_bytes; })},
      {"renderer", "encode_threads",
       integer(
           1, 64, [](Config & c) -> auto& { return c.renderer.encode_threads; })},
      {"log", "level", TextKey{set_log_level}},
      {"process", "core_dumps",
       plain<BooleanKey>([](Config & c) -> auto& { return c.core_dumps; })},
  };
}

}  // namespace

const std::vector<ConfigKey>& config_keys() {
  static const std::vector<ConfigKey> all = [] {
    std::vector<ConfigKey> keys = server_keys();
    std::ranges::copy(seat_keys(), std::back_inserter(keys));
    std::ranges::copy(session_keys(), std::back_inserter(keys));
    std::ranges::copy(other_keys(), std::back_inserter(keys));
    return keys;
  }();
  return all;
}

}  // namespace cutaway
