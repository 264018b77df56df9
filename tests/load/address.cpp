#include "load/address.h"

#include <regex>
#include <stdexcept>

namespace cutaway::load {

Address parse_address(const std::string& url) {
  static const std::regex form(
      R"(ws://(\[[0-9A-Fa-f:.]+\]|[^\[\]/:?#]+)(?::([0-9]{1,5}))?(/[^#]*)?)");
  std::smatch parts;
  if (!std::regex_match(url, parts, form))
    throw std::invalid_argument("expected ws://HOST:PORT/PATH; came \"" + url + "\"");
  Address address{parts[1], parts[2].matched ? parts[2].str() : "80",
                  parts[3].matched ? parts[3].str() : "/"};
  if (address.host.front() == '[') address.host = address.host.substr(1, address.host.size() - 2);
  return address;
}

}  // namespace cutaway::load
