// Why a document does not follow a schema, in words for the person who wrote it.
#pragma once

#include <optional>
#include <string>

#include "core/error.h"
#include "scene/json.h"

namespace cutaway {

/// The first field of `value` that breaks `schema` (a node without $refs); its pointer begins at
/// `value`.
std::optional<Error::Detail> first_violation(const Json& schema, const Json& value);

/// Whether first_violation knows what a node says with this keyword, or may ignore it.
bool is_known_keyword(const std::string& keyword);

}  // namespace cutaway
