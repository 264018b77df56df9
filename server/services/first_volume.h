// Which volume a page opens that names none.
#pragma once

#include "volume/volume.h"

namespace cutaway {

/// How well a volume is worth seeing at first, 0 to 1, as far as its header tells: a large grid of
/// about cubic voxels before a slab, a CT before an MR before anything else, and each of them
/// before a mask or a label map, which their names tell.
double worth_seeing(const VolumeDescription& description, const VolumeGeometry& geometry);

}  // namespace cutaway
