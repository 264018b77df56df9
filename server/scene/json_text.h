// JSON text from and to the outside.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/json.h"

namespace cutaway {

/// Objects and arrays inside each other; more is refused before anything recurses over it.
inline constexpr std::size_t kMaximumJsonDepth = 32;

/// One JSON document. A number without a fraction is an integer however it is written (1.0, 1e3),
/// as in JSON Schema. Throws Error: malformed-json with the byte at which reading stopped, or
/// not-finite with the field of a number that no double holds.
Json parse_json(std::string_view text);

/// JSON text with 0 in the place of each number that no double holds, so that the rest of it can be
/// read.
std::string with_numbers_held(std::string text);

/// Never throws for the content: bytes that are not UTF-8 (titles from files) become U+FFFD.
std::string json_text(const Json& value);

/// At most `bytes` of a text for an error message, cut between characters and marked where cut.
std::string shortened(std::string text, std::size_t bytes = 80);

/// `pointer` followed by one more reference token, escaped (RFC 6901).
std::string pointer_to(const std::string& pointer, std::string_view key);
std::string pointer_to(const std::string& pointer, std::size_t index);

}  // namespace cutaway
