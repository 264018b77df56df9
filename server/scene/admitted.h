// The one gate through which pass what the server has chosen: its own schema accepts the result.
#pragma once

#include <string_view>

#include "scene/json.h"

namespace cutaway {

/// The document with every number brought within the limits that the schema gives its field, by the
/// name of its place; what is no number at all (NaN) becomes the lowest. A document that a client
/// sent has passed validate() and is not changed. Thread-safe.
Json admitted(Json document, std::string_view schema_name);

}  // namespace cutaway
