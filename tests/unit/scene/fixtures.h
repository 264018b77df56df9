// The documents of protocol/fixtures that both languages must accept or must refuse.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scene/json.h"

namespace cutaway {

struct Fixture {
  std::string name;    ///< the file's, without .json
  std::string schema;  ///< which it is a document of
  std::string text;    ///< the document
  Json error;          ///< of an invalid one: code and field
};

std::vector<Fixture> valid_fixtures();
std::vector<Fixture> invalid_fixtures();

/// Those of another folder of protocol/fixtures, by name.
std::map<std::string, Json> json_fixtures(const std::string& folder);

std::map<std::string, std::vector<std::uint8_t>> binary_fixtures(const std::string& folder);

/// Puts a document through what the server does with one from outside. Throws Error.
void accept(const std::string& schema, const std::string& text);

}  // namespace cutaway
