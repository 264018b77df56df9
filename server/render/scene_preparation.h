// What a volume goes through before it is drawn, as a scene asks for it.
#pragma once

#include "scene/scene.h"
#include "volume/prepared/preparation.h"

namespace cutaway {

/// Of a first look at a volume.
Preparation first_preparation(const Findings& findings);

/// In the volume's terms; nothing for a slice. Filling raises values to between the two surfaces,
/// where neither is changed by it.
VolumePreparation preparation_of(const Scene& scene, const LoadedVolume& volume);

/// As preparation_of, for a scene that leaves all to the volume.
VolumePreparation preparation_of_first_look(const LoadedVolume& volume);

}  // namespace cutaway
