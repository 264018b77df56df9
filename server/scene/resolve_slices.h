// The slices' part of resolve_scene.
#pragma once

#include "scene/json.h"
#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// `document`: the scene's `slices` with its schema's defaults. Throws Error where its directions
/// span no plane.
void complete_slices(Slices& slices, const Json& said, const VolumeFacts& volume);

}  // namespace cutaway
