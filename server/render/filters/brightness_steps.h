// Steps that filters which draw lines from the brightness have in common (brightness.glsl).
#pragma once

#include "render/filters/image_filter.h"

namespace cutaway {

inline constexpr WorkTexture kScales{WorkFormat::rgba32f, 0};
inline constexpr WorkTexture kScratch{WorkFormat::rgba32f, 1};

/// How far the wider of the two Gaussians looks.
int wide_reach_px(double sigma_px);

/// The brightness at two scales, left in kScales, by the filter's shaders number `shader` and the
/// next: brightness_rows.frag and brightness_columns.frag.
std::vector<FilterStep> scale_steps(int shader, double sigma_px);

/// A length of the module in pixels of the picture.
double length_px(const Json& parameters, const char* name, double resolution_scale);

/// What a filter that draws ink has for its last shader, and its Gaussian.
void offer_ink(const gl::Program& program, const Json& parameters, double resolution_scale);

}  // namespace cutaway
