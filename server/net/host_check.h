// Was the request meant for this server?
#pragma once

#include <string_view>

#include "net/settings.h"

namespace cutaway {

/// A page of a stranger can have its own name point to this server (DNS rebinding), and is of the
/// same origin then. So `host` (a Host header, its port does not matter) has to be localhost,
/// 127.0.0.1, [::1], the address listened on, one of `settings.hosts` or the host of an allowed
/// origin. Where `settings` listen on an address that others reach, an IP literal is right, too: no
/// name was asked for it.
bool host_allowed(std::string_view host, const NetSettings& settings);

/// What host_allowed takes, for people.
std::string allowed_hosts_in_words(const NetSettings& settings);

/// Is this the address of a machine's own loopback? False for what is no address.
bool is_loopback_address(const std::string& address);

}  // namespace cutaway
