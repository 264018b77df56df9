// Why a document does not follow a schema, in words for the person who wrote it.
#pragma once

#include <optional>
#include <string>

#include "core/error.h"
#include "scene/json.h"

namespace cutaway {

/// The first field of `value` that breaks `schema` (a node without $refs); `pointer` is where
/// `value` stands. Knows the keywords that protocol/schema uses.
std::optional<Error::Detail> first_violation(const Json& schema, const Json& value,
                                             const std::string& pointer);

}  // namespace cutaway
