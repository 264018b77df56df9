// Blurs and structure tensors in double: what several of the reference's filters are made of.
#pragma once

#include "support/reference_image.h"

namespace cutaway::reference {

using Field = Image<glm::dvec4>;  ///< three numbers times their weight, and the weight

/// Colours times coverage.
Field weighed_colours(const BranchImage& input);

/// By a Gaussian that is cut off at 2.5 sigma, row by row, then column by column. What lies beyond
/// the picture has no weight.
Field blurred(const Field& field, double sigma_px);
/// In the one direction only.
Field blurred_along(const Field& field, glm::ivec2 along, double sigma_px);

/// The three numbers by their weight; 0 where there is none.
glm::dvec3 mean(const glm::dvec4& weighed);

struct Flow {
  glm::dvec2 along{0.0, 1.0};  ///< unit; the way in which the picture changes least
  double coherence = 0.0;
};

/// Of a smoothed structure tensor: xx, xy, yy.
Flow flow_from(const glm::dvec4& tensor);

/// Of the structure tensor of `colours`, itself smoothed by `smoothing_px`.
Image<Flow> flow_of(const BranchImage& input, const Field& colours, double smoothing_px);

}  // namespace cutaway::reference
