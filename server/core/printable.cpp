#include "core/printable.h"

#include <fmt/format.h>

namespace cutaway {

namespace {

constexpr unsigned char kDelete = 0x7F;
constexpr unsigned char kLeadOfC1 = 0xC2;  // in UTF-8, before 0x80 to 0x9F

bool is_control(unsigned char byte) { return byte < 0x20 || byte == kDelete; }
bool is_second_of_c1(unsigned char byte) { return byte >= 0x80 && byte < 0xA0; }

std::string escaped(unsigned char control) {
  if (control == '\n') return "\\n";
  if (control == '\r') return "\\r";
  if (control == '\t') return "\\t";
  return fmt::format("\\x{:02x}", control);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
    if (is_control(byte)) {
      result += escaped(byte);
    } else if (byte == kLeadOfC1 && is_second_of_c1(next)) {
      result += escaped(next);
      ++i;
    } else {
      result += text[i];
    }
  }
  return result;
}

}  // namespace cutaway
