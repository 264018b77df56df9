// Was the request meant for this server?
#pragma once

#include <string_view>

#include "net/settings.h"

namespace cutaway {

/// A page of a stranger can have its own name point to a server that listens only to this machine
/// (DNS rebinding), and is of the same origin then. So where `settings` listen on a loopback
/// address, `host` (a Host header, its port does not matter) has to be localhost, 127.0.0.1, [::1],
/// the address itself or the host of an allowed origin. Elsewhere any host is right: which names
/// lead here is not known.
bool host_allowed(std::string_view host, const NetSettings& settings);

}  // namespace cutaway
