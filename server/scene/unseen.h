// Why a picture shows less than its user expects: values and places that leave nothing to see.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// One sentence a reason; none where something of each branch that is drawn can be seen, as far as
/// some 400 rays tell. Of a slice: none. Thread-safe.
std::vector<std::string> reasons_for_nothing(const Scene& scene, const VolumeFacts& volume);

}  // namespace cutaway
