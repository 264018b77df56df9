#include "net/client_address.h"

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "net/header_text.h"

namespace cutaway {

namespace ip = boost::asio::ip;

namespace {

/// IPv4 within IPv6 (::ffff:192.0.2.1), as a listener on :: gets it, is the IPv4 address.
ip::address plain(const ip::address& address) {
  if (!address.is_v6() || !address.to_v6().is_v4_mapped()) return address;
  return ip::make_address_v4(ip::v4_mapped, address.to_v6());
}

std::string group_of(const ip::address& address) {
  if (address.is_v4()) return address.to_string();
  ip::address_v6::bytes_type bytes = address.to_v6().to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  return ip::address_v6(bytes).to_string() + "/64";
}

std::optional<ip::address> address_of(std::string_view text) {
  boost::system::error_code error;
  const ip::address address = ip::make_address(std::string(text), error);
  if (error) return std::nullopt;
  return plain(address);
}

/// Some proxies add a port: "192.0.2.1:4711", "[2001:db8::1]:4711".
std::optional<ip::address> forwarded_address(std::string_view entry) {
  const std::size_t bracket = entry.find(']');
  if (entry.starts_with('[') && bracket != entry.npos)
    return address_of(entry.substr(1, bracket - 1));
  const bool has_port = std::ranges::count(entry, ':') == 1;
  return address_of(has_port ? entry.substr(0, entry.find(':')) : entry);
}

Error no_proxy(const std::string& entry) {
  return Error({.code = ErrorCode::wrong_type,
                .message = "this is no address of a proxy",
                .expected = "an IP address or a network such as 10.0.0.0/8",
                .received = entry});
}

}  // namespace

TrustedProxies::TrustedProxies(const std::vector<std::string>& entries) {
  for (const std::string& entry : entries) {
    const bool is_network = entry.find('/') != std::string::npos;
    const bool is_v6 = entry.find(':') != std::string::npos;
    const std::string network = is_network ? entry : entry + (is_v6 ? "/128" : "/32");
    boost::system::error_code error;
    if (is_v6) {
      networks_.emplace_back(ip::make_network_v6(network, error));
    } else {
      networks_.emplace_back(ip::make_network_v4(network, error));
    }
    if (error) throw no_proxy(entry);
  }
}

// A network's hosts are those that, as networks of their own, are its subnets or itself.
bool TrustedProxies::contains(const ip::address& peer) const {
  const ip::address address = plain(peer);
  return std::ranges::any_of(networks_, [&](const auto& each) {
    if (const auto* v4 = std::get_if<ip::network_v4>(&each)) {
      return address.is_v4() &&
             ip::network_v4(address.to_v4(), v4->prefix_length()).canonical() == v4->canonical();
    }
    const auto& v6 = std::get<ip::network_v6>(each);
    return address.is_v6() &&
           ip::network_v6(address.to_v6(), v6.prefix_length()).canonical() == v6.canonical();
  });
}

ClientAddresses::ClientAddresses(const std::vector<std::string>& trusted_proxies,
                                 bool limit_loopback)
    : proxies_(trusted_proxies), limit_loopback_(limit_loopback) {}

ClientAddress ClientAddresses::counted(const ip::address& address, bool is_exempt) const {
  ClientAddress client{address.to_string(), group_of(address), is_exempt};
  if (is_exempt) client.group += '#' + std::to_string(exempt_.fetch_add(1));
  return client;
}

ClientAddress ClientAddresses::of_peer(const ip::address& peer) const {
  const ip::address address = plain(peer);
  const bool is_free_loopback = address.is_loopback() && !limit_loopback_;
  return counted(address, is_free_loopback || is_trusted(address));
}

ClientAddress ClientAddresses::of_request(const ip::address& peer,
                                          std::string_view forwarded_for) const {
  ip::address client = plain(peer);
  bool is_forwarded = false;
  while (proxies_.contains(client) && !forwarded_for.empty()) {
    const std::size_t comma = forwarded_for.rfind(',');
    const std::size_t begin = comma == std::string_view::npos ? 0 : comma + 1;
    const auto before = forwarded_address(trimmed_text(forwarded_for.substr(begin)));
    if (!before) return counted(plain(peer), false);
    client = *before;
    forwarded_for = forwarded_for.substr(0, comma == std::string_view::npos ? 0 : comma);
    is_forwarded = true;
  }
  // Whoever comes by a tunnel or writes the field himself may be a loopback address to a proxy.
  return is_forwarded && client.is_loopback() ? counted(client, false) : of_peer(client);
}

}  // namespace cutaway
