// Assertions about our own code, on in every build. A failure prints both values and ends the
// process.
#pragma once

#include <source_location>
#include <sstream>
#include <string>
#include <string_view>

namespace cutaway {

[[noreturn]] void check_failed(std::string_view what, const std::string& values,
                               std::source_location where);

inline void check(bool condition, std::string_view what,
                  std::source_location where = std::source_location::current()) {
  if (!condition) check_failed(what, "", where);
}

template <typename A, typename B>
void check_equal(const A& a, const B& b, std::string_view what,
                 std::source_location where = std::source_location::current()) {
  if (a == b) return;
  std::ostringstream values;
  values << a << " != " << b;
  check_failed(what, values.str(), where);
}

}  // namespace cutaway
