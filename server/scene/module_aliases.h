// Parameters that go by a second name: what a scene says with one is turned into what the module
// knows, so that everything behind reads one name.
#pragma once

#include "scene/json.h"

namespace cutaway {

/// The scene document (or patch) with each alias replaced: a tone's `ts` by its `detail`, a
/// Kuwahara `window` by its `radius`, as "x-alias" in the modules' schema says. Throws Error where
/// a module has both or the alias' value breaks its own limits; passes over what is not shaped as a
/// module, which is the schema check's to refuse.
Json without_aliases(Json document);

}  // namespace cutaway
