// Steps that filters which follow the picture's edges have in common.
#pragma once

#include "render/filters/image_filter.h"

namespace cutaway {

/// How far a blur looks (blur.glsl).
int blur_reach_px(double sigma_px);

/// A step of blur_colours.frag or blur.frag, which is the filter's shader number `shader`.
FilterStep blur_step(int shader, const WorkTexture& from, const WorkTexture& to, glm::ivec2 along,
                     double sigma_px);

}  // namespace cutaway
