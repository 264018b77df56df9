// The filters that draw from the brightness, in double.
#pragma once

#include "scene/scene.h"
#include "support/reference_image.h"

namespace cutaway::reference {

/// Whether `filter` is one of them.
bool draws_from_brightness(const Module& filter);

/// Lengths are the viewport's.
BranchImage apply_brightness_filter(const BranchImage& input, const Module& filter,
                                    double resolution_scale);

}  // namespace cutaway::reference
