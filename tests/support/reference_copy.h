// A volume's first coarser copy for the reference renderer, in double.
#pragma once

#include <vector>

#include "volume/volume.h"

namespace cutaway::reference {

/// Means of two voxels along each axis whose spacing is less than twice the smallest; the volume
/// itself where such an axis has fewer than eight.
class ReferenceCopy {
 public:
  explicit ReferenceCopy(const Volume& volume);

  /// Trilinear, at a continuous index of the volume.
  double value(glm::dvec3 index) const;

 private:
  double texel(glm::ivec3 at) const;

  glm::ivec3 factor_{1};
  glm::ivec3 size_{0};
  std::vector<double> means_;
};

}  // namespace cutaway::reference
