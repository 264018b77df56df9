#include "net/request_head.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/string.hpp>
#include <boost/beast/http/parser.hpp>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include "net/header_text.h"

namespace cutaway {

namespace http = boost::beast::http;

namespace {

constexpr std::string_view kTokenMarks = "!#$%&'*+-.^_`|~";  // RFC 9110, 5.6.2
constexpr std::string_view kHostMarks = "-._~%!$&'()*+,;=";  // RFC 3986, 3.2.2
constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kHexDigits = "0123456789abcdefABCDEF";

bool is_alphanumeric(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_token(char c) {
  return is_alphanumeric(c) || kTokenMarks.find(c) != std::string_view::npos;
}

bool is_control(char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f; }

bool is_blank(char c) { return c == ' ' || c == '\t'; }

bool is_port(std::string_view digits) {
  if (digits.find_first_not_of(kDigits) != std::string_view::npos) return false;
  std::uint16_t port = 0;
  return digits.empty() ||
         std::from_chars(digits.data(), digits.data() + digits.size(), port).ec == std::errc();
}

bool is_name_or_address(std::string_view host) {
  if (!host.starts_with('[')) {
    return std::ranges::all_of(host, [](char c) {
      return is_alphanumeric(c) || kHostMarks.find(c) != std::string_view::npos;
    });
  }
  return host.size() > 2 && host.ends_with(']') &&
         host.substr(1, host.size() - 2).find_first_not_of(std::string(kHexDigits) + ":.") ==
             std::string_view::npos;
}

HeadRefusal malformed(std::string reason) { return {http::status::bad_request, std::move(reason)}; }

std::optional<HeadRefusal> wrong_host(const HttpRequest& request) {
  const std::size_t hosts = request.count(http::field::host);
  if (hosts > 1) return malformed("The request has several Host fields.");
  if (hosts == 0 && request.version() >= 11) return malformed("The request has no Host field.");
  if (is_host_and_port(view_of(request[http::field::host]))) return std::nullopt;
  return malformed("The request's Host is no host and port.");
}

// RFC 9112, 6.1 and 6.3: what could be framed in two ways is refused.
std::optional<HeadRefusal> wrong_framing(const HttpRequest& request) {
  const std::size_t lengths = request.count(http::field::content_length);
  if (lengths > 1) return malformed("The request has several Content-Length fields.");
  const std::string_view length = view_of(request[http::field::content_length]);
  if (length.find_first_not_of(kDigits) != std::string_view::npos) {
    return malformed("The request's Content-Length is no number.");
  }
  if (request.count(http::field::transfer_encoding) == 0) return std::nullopt;
  if (lengths > 0) return malformed("The request has Content-Length and Transfer-Encoding.");
  if (request.version() < 11) return malformed("HTTP/1.0 knows no Transfer-Encoding.");
  if (request.count(http::field::transfer_encoding) == 1 &&
      same_text(view_of(request[http::field::transfer_encoding]), "chunked")) {
    return std::nullopt;
  }
  return HeadRefusal{http::status::not_implemented,
                     "The only Transfer-Encoding known here is chunked."};
}

/// The authority of a target in absolute-form, and what comes after it.
struct AbsoluteTarget {
  std::string authority;
  std::string rest;
};

std::optional<AbsoluteTarget> absolute_target(std::string_view target) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (!same_text(target.substr(0, scheme.size()), scheme)) continue;
    const std::string_view after = target.substr(scheme.size());
    const std::size_t end = std::min(after.find_first_of("/?#"), after.size());
    std::string rest(after.substr(end));
    if (!rest.starts_with('/')) rest.insert(0, 1, '/');
    return AbsoluteTarget{std::string(after.substr(0, end)), std::move(rest)};
  }
  return std::nullopt;
}

std::optional<HeadRefusal> bring_into_origin_form(HttpRequest& request) {
  const auto absolute = absolute_target(view_of(request.target()));
  if (!absolute) return std::nullopt;
  if (absolute->authority.empty() || !is_host_and_port(absolute->authority)) {
    return malformed("The authority of the request's target is no host and port.");
  }
  request.target(absolute->rest);
  request.set(http::field::host, absolute->authority);
  return std::nullopt;
}

}  // namespace

HeadScanner::State HeadScanner::scan(std::string_view bytes) {
  while (scanned_ < bytes.size()) {
    const State state = step(bytes[scanned_++]);
    if (state != State::incomplete) return state;
  }
  return State::incomplete;
}

HeadScanner::State HeadScanner::step(char c) {
  if (after_return_) return c == '\n' ? end_line() : State::malformed;
  if (c == '\r') {
    after_return_ = true;
    return State::incomplete;
  }
  const bool begins_request = lines_ == 0 && line_bytes_ == 0;
  if (is_control(c)) return State::malformed;
  if (line_bytes_ == 0 && is_blank(c)) return State::malformed;
  if (begins_request && !is_token(c)) return State::malformed;
  ++line_bytes_;
  return State::incomplete;
}

// One empty line before the request is left out of account (RFC 9112, 2.2).
HeadScanner::State HeadScanner::end_line() {
  after_return_ = false;
  if (line_bytes_ > 0) {
    ++lines_;
    line_bytes_ = 0;
    return State::incomplete;
  }
  if (lines_ > 0) return State::complete;
  return std::exchange(had_empty_line_, true) ? State::malformed : State::incomplete;
}

std::variant<HttpRequest, HeadRefusal> read_head(std::string_view head) {
  if (head.starts_with("\r\n")) head.remove_prefix(2);
  http::request_parser<http::empty_body> parser;
  parser.header_limit(kHeadBytes);
  parser.body_limit(std::numeric_limits<std::uint64_t>::max());  // judged below, by route
  boost::system::error_code error;
  parser.put(boost::asio::buffer(head.data(), head.size()), error);
  if (error || !parser.is_header_done()) return malformed("This is no HTTP request.");
  HttpRequest request = parser.release();
  if (auto refusal = wrong_host(request)) return std::move(*refusal);
  if (auto refusal = wrong_framing(request)) return std::move(*refusal);
  if (auto refusal = bring_into_origin_form(request)) return std::move(*refusal);
  return request;
}

bool announces_body_over(const HttpRequest& request, std::uint64_t most) {
  if (request.count(http::field::transfer_encoding) > 0) return true;
  const std::string_view length = view_of(request[http::field::content_length]);
  std::uint64_t bytes = 0;
  const auto read = std::from_chars(length.data(), length.data() + length.size(), bytes);
  return !length.empty() && (read.ec != std::errc() || bytes > most);
}

bool is_host_and_port(std::string_view host) {
  const std::size_t bracket = host.rfind(']');
  const std::size_t colon = host.find(':', bracket == std::string_view::npos ? 0 : bracket);
  const bool has_port = colon != std::string_view::npos;
  return is_name_or_address(host.substr(0, colon)) &&
         (!has_port || is_port(host.substr(colon + 1)));
}

}  // namespace cutaway
