// Whose connection or request it is: what is counted against which limit.
#pragma once

#include <atomic>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/network_v4.hpp>
#include <boost/asio/ip/network_v6.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cutaway {

struct ClientAddress {
  std::string text;  ///< for the log
  /// Those of one group share its limits: an IPv4 address, or the /64 of an IPv6 one, which is what
  /// one customer has. Who is exempt is a group of its own each time.
  std::string group;
  bool is_exempt = false;  ///< from limits and shares
};

/// Addresses and networks ("10.0.0.0/8") whose X-Forwarded-For is believed.
class TrustedProxies {
 public:
  /// Throws Error naming the entry that is neither.
  explicit TrustedProxies(const std::vector<std::string>& entries);
  bool contains(const boost::asio::ip::address& address) const;

 private:
  std::vector<std::variant<boost::asio::ip::network_v4, boost::asio::ip::network_v6>> networks_;
};

/// Immutable but for a counter, so any thread may ask.
class ClientAddresses {
 public:
  /// Loopback addresses are exempt unless `limit_loopback`.
  ClientAddresses(const std::vector<std::string>& trusted_proxies, bool limit_loopback);

  /// Of a connection before it has said anything; a trusted proxy's is exempt, since it brings
  /// many.
  ClientAddress of_peer(const boost::asio::ip::address& peer) const;
  /// Of a request: behind trusted proxies the last address of `forwarded_for` (all fields' lists,
  /// in order) that is none of them. Where one of those read on the way is no address, the peer's
  /// own, which is no longer exempt then. Nor is a loopback address that was forwarded: it is no
  /// more than a proxy's word for one.
  ClientAddress of_request(const boost::asio::ip::address& peer,
                           std::string_view forwarded_for) const;
  bool is_trusted(const boost::asio::ip::address& peer) const { return proxies_.contains(peer); }

 private:
  ClientAddress counted(const boost::asio::ip::address& address, bool is_exempt) const;

  TrustedProxies proxies_;
  bool limit_loopback_;
  mutable std::atomic<std::uint64_t> exempt_{0};
};

}  // namespace cutaway
