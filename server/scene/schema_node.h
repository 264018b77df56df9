// Reading one node of a schema without $refs: what both checking and filling need.
#pragma once

#include <string>

#include "scene/json.h"

namespace cutaway {

/// Of a node that is one of several objects ("oneOf"): the field by whose constant they differ,
/// "name" or "type".
std::string discriminator(const Json& schema);

/// The one of several that `value` says it is; null where it says none of them.
const Json* chosen_branch(const Json& schema, const Json& value);

/// What a node says with a keyword; null where it does not use it.
const Json* keyword(const Json& schema, const char* name);

/// The schema of a field; null where the object has no such field.
const Json* property(const Json& schema, const std::string& key);

}  // namespace cutaway
