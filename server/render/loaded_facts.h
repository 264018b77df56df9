// What a scene needs to know of a volume that is in memory.
#pragma once

#include <memory>

#include "scene/volume_facts.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// The facts hold the volume for as long as their ray probe lives.
VolumeFacts facts_of(std::shared_ptr<const LoadedVolume> loaded);

}  // namespace cutaway
