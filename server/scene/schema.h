// The JSON Schemas of protocol/schema, compiled into the program: what a document may hold, and
// what it holds where it says nothing. All functions are thread-safe.
#pragma once

#include <string>
#include <string_view>

#include "scene/json.h"

namespace cutaway {

/// The schema file NAME.schema.json with every $ref replaced by what it names; throws
/// std::out_of_range for another name.
const Json& schema(std::string_view name);

/// Throws Error where `value` does not follow the schema: the first field that is wrong as a JSON
/// pointer, the limit with its unit, and what came. Where an object can be one of several (modules,
/// messages) its own "name" or "type" decides which one is meant.
void validate(const Json& value, std::string_view schema_name);

/// A valid document in which every field that has a default in the schema is there.
Json with_defaults(Json value, std::string_view schema_name);

struct NumberRange {
  double minimum;
  double maximum;
};

/// The limits of a number at `pointer` inside of the schema, such as
/// "/properties/lens/properties/radius_mm".
NumberRange number_range(std::string_view schema_name, const std::string& pointer);

}  // namespace cutaway
