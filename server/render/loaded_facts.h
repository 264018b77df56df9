// What a scene needs to know of a volume that is in memory.
#pragma once

#include <memory>

#include "scene/volume_facts.h"
#include "volume/loaded_volume.h"

namespace cutaway {

/// The probe holds the volume.
SurfaceProbe probe_of(std::shared_ptr<const LoadedVolume> volume);

/// `seen`: the volume as it is prepared for a first look, whose probe looks at it and holds it.
VolumeFacts facts_of(const LoadedVolume& loaded, std::shared_ptr<const LoadedVolume> seen);
/// The same of a volume that is seen as it was measured.
VolumeFacts facts_of(const std::shared_ptr<const LoadedVolume>& loaded);

}  // namespace cutaway
