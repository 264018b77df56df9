#include "support/reference_copy.h"

#include <algorithm>

namespace cutaway::reference {

namespace {

glm::ivec3 factors_of(const VolumeGeometry& geometry) {
  const glm::dvec3 spacing_mm = geometry.spacing_mm;
  glm::ivec3 factor(1);
  for (int axis = 0; axis < 3; ++axis) {
    if (spacing_mm[axis] >= 2.0 * std::min({spacing_mm.x, spacing_mm.y, spacing_mm.z})) continue;
    if (geometry.size_voxels[axis] < 8) return glm::ivec3(1);
    factor[axis] = 2;
  }
  return factor;
}

}  // namespace

ReferenceCopy::ReferenceCopy(const Volume& volume)
    : factor_(factors_of(volume.geometry)),
      size_((volume.geometry.size_voxels + factor_ - 1) / factor_) {
  for (int z = 0; z < size_.z; ++z) {
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        double sum = 0.0;
        for (int i = 0; i < 8; ++i) {
          const glm::ivec3 within = glm::ivec3(i & 1, (i >> 1) & 1, i >> 2) % factor_;
          sum += value_at(volume, glm::ivec3(x, y, z) * factor_ + within);
        }
        means_.push_back(sum / 8.0);
      }
    }
  }
}

double ReferenceCopy::texel(glm::ivec3 at) const {
  const glm::ivec3 inside = glm::clamp(at, glm::ivec3(0), size_ - 1);
  return means_[(static_cast<std::size_t>(inside.z) * size_.y + inside.y) * size_.x + inside.x];
}

double ReferenceCopy::value(glm::dvec3 index) const {
  const glm::dvec3 at = (index + 0.5) / glm::dvec3(factor_) - 0.5;
  const glm::dvec3 below = glm::floor(at);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 corner(i & 1, (i >> 1) & 1, i >> 2);
    const glm::dvec3 apart = glm::abs(below + glm::dvec3(corner) - at);
    sum += (1.0 - apart.x) * (1.0 - apart.y) * (1.0 - apart.z) * texel(glm::ivec3(below) + corner);
  }
  return sum;
}

}  // namespace cutaway::reference
