// Schemas and values in words, for error messages.
#pragma once

#include <cstddef>
#include <string>

#include "scene/json.h"

namespace cutaway {

/// What a node allows: "a number from 0 to 2000 mm", "one of flat, gradient, open".
std::string words_for(const Json& schema);

/// The branches of a oneOf by name.
std::string words_for_branches(const Json& schema);

/// The fields of an object by name.
std::string words_for_fields(const Json& schema);

/// A value as JSON, shortened.
std::string words_for_value(const Json& value);

/// Unicode characters of a JSON string.
std::size_t character_count(const Json& text);

}  // namespace cutaway
