// Text of a request's head, as Beast has it, in the standard library's terms.
#pragma once

#include <algorithm>
#include <boost/beast/core/string.hpp>
#include <string_view>

namespace cutaway {

inline std::string_view view_of(boost::beast::string_view text) {
  return {text.data(), text.size()};
}

/// Upper and lower case are the same: names of hosts, schemes and codings.
inline bool same_text(std::string_view a, std::string_view b) {
  return boost::beast::iequals({a.data(), a.size()}, {b.data(), b.size()});
}

/// Without the blanks around it (RFC 9110, 5.6.3).
inline std::string_view trimmed_text(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

}  // namespace cutaway
