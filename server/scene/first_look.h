// The look in which a volume is first seen.
#pragma once

#include "scene/json.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// A document that says nothing of a look gets the style that suits the volume; any word of a look,
/// and the document is left as it is. Not part of resolving: there what is left open stays as the
/// schema has it, so that an old document draws its old picture. Thread-safe.
Json with_first_look(Json document, const VolumeFacts& volume);

/// Whether the look of a resolved scene's complete document is the volume's first one, so that
/// nobody chose it.
bool has_first_look(const Json& document, const VolumeFacts& volume, Viewport viewport);

}  // namespace cutaway
