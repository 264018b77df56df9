#include "net/host_check.h"

#include <algorithm>
#include <array>
#include <boost/asio/ip/address.hpp>
#include <boost/beast/core/string.hpp>
#include <string>

#include "net/header_text.h"

namespace cutaway {

namespace {

constexpr std::array<std::string_view, 3> kThisMachine = {"localhost", "127.0.0.1", "[::1]"};

std::string_view without_port(std::string_view host) {
  const std::size_t colon = host.rfind(':');
  const bool in_brackets = colon != std::string_view::npos && host.find(']', colon) != host.npos;
  return in_brackets ? host : host.substr(0, colon);
}

std::string_view host_of_origin(std::string_view origin) {
  const std::size_t scheme = origin.find("://");
  return without_port(scheme == std::string_view::npos ? origin : origin.substr(scheme + 3));
}

bool is_ip_literal(std::string_view host) {
  const bool in_brackets = host.starts_with('[') && host.ends_with(']') && host.size() > 2;
  const std::string address(in_brackets ? host.substr(1, host.size() - 2) : host);
  boost::system::error_code error;
  const auto read = boost::asio::ip::make_address(address, error);
  return !error && read.is_v6() == in_brackets;
}

}  // namespace

bool is_loopback_address(const std::string& address) {
  boost::system::error_code error;
  return boost::asio::ip::make_address(address, error).is_loopback() && !error;
}

bool host_allowed(std::string_view host, const NetSettings& settings) {
  const std::string_view name = without_port(host);
  const auto is_name = [name](std::string_view each) { return same_text(name, each); };
  if (std::ranges::any_of(kThisMachine, is_name) || is_name(settings.address) ||
      std::ranges::any_of(settings.hosts, is_name) ||
      std::ranges::any_of(settings.allowed_origins, is_name, host_of_origin)) {
    return true;
  }
  return !is_loopback_address(settings.address) && is_ip_literal(name);
}

std::string allowed_hosts_in_words(const NetSettings& settings) {
  return is_loopback_address(settings.address)
             ? "This server listens on a loopback address and answers only to localhost, "
               "127.0.0.1, [::1] and the hosts of the configuration's hosts and allowed_origins."
             : "This server answers only to IP addresses and the hosts of the configuration's "
               "hosts "
               "and allowed_origins.";
}

}  // namespace cutaway
