// Where the server is.
#pragma once

#include <string>

namespace cutaway::load {

struct Address {
  std::string host;
  std::string port;
  std::string path;
};

/// "ws://HOST[:PORT][/PATH]", an IPv6 address in brackets. Throws std::invalid_argument that says
/// what was expected and what came.
Address parse_address(const std::string& url);

}  // namespace cutaway::load
