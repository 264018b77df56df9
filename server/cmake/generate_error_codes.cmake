# Writes OUTPUT: the error codes of SCHEMA (protocol/schema/error.schema.json) as an enum with their words.
file(READ ${SCHEMA} schema)
string(JSON codes GET "${schema}" definitions code enum)
string(JSON count LENGTH "${codes}")
math(EXPR last "${count} - 1")
set(enumerators "")
set(words "")
foreach(i RANGE ${last})
  string(JSON word GET "${codes}" ${i})
  string(REPLACE "-" "_" enumerator ${word})
  string(APPEND enumerators "  ${enumerator},\n")
  string(APPEND words "    \"${word}\",\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated from protocol/schema/error.schema.json.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string_view>

namespace cutaway {

/// What went wrong, for programs; the words are those of the wire.
enum class ErrorCode : std::uint8_t {
${enumerators}};

inline constexpr std::array<std::string_view, ${count}> kErrorCodeWords{
${words}};

constexpr std::string_view code_word(ErrorCode code) {
  return kErrorCodeWords.at(static_cast<std::size_t>(code));
}

/// Nothing for a word that is none of them.
constexpr std::optional<ErrorCode> error_code_from(std::string_view text) {
  for (std::size_t i = 0; i < kErrorCodeWords.size(); ++i)
    if (kErrorCodeWords[i] == text) return static_cast<ErrorCode>(i);
  return std::nullopt;
}

inline std::ostream& operator<<(std::ostream& stream, ErrorCode code) {
  return stream << code_word(code);
}

}  // namespace cutaway
")
