// Pen and ink again, in double; see reference_filters.h.
#pragma once

#include "scene/json.h"
#include "support/reference_image.h"

namespace cutaway::reference {

/// `parameters`: the module's, with lengths in pixels of the viewport.
BranchImage hatching(const BranchImage& input, const Json& parameters, double resolution_scale);

}  // namespace cutaway::reference
