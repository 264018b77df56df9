// Specks of a material.
#pragma once

#include <stop_token>

#include "volume/prepared/preparation.h"

namespace cutaway {

/// Takes every connected part (26 neighbours) of a band's material that is smaller out of the band:
/// its voxels get the band's lower end. A band with an upper end is left as it is, and so is one of
/// which all parts are that small.
void drop_islands(Volume& volume, const IslandLimit& limit, const std::stop_token& stop);

}  // namespace cutaway
