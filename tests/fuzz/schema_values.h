// Values that follow a schema, so that what lies behind its check is reached.
#pragma once

#include "fuzz/json_mutator.h"

namespace cutaway::fuzz {

/// A value for the inlined schema `node` (scene/schema.h). Of an object what is required is there,
/// and about a third of the rest. Numbers lie at their limits or anywhere between.
Json value_for(const Json& node, Generator& generator);

/// One of `node`'s fields, however deep, with a value of value_for: an object of objects down to
/// it.
Json field_for(const Json& node, Generator& generator);

}  // namespace cutaway::fuzz
