// Text from outside, fit for a line of a log or a terminal.
#pragma once

#include <string>
#include <string_view>

namespace cutaway {

/// `text` with every control character (C0, DEL and C1 in UTF-8) written as \n, \t or \x1b: a
/// stranger's text begins no line of its own and moves no cursor.
std::string printable(std::string_view text);

}  // namespace cutaway
