#include "volume/geometry.h"

#include <algorithm>
#include <array>

namespace cutaway {

namespace {

glm::dmat3 axes_patient_mm(const VolumeGeometry& geometry) {
  glm::dmat3 axes = geometry.direction_patient;
  for (int axis = 0; axis < 3; ++axis) axes[axis] *= geometry.spacing_mm[axis];
  return axes;
}

}  // namespace

glm::dmat4 index_to_patient(const VolumeGeometry& geometry) {
  glm::dmat4 matrix(axes_patient_mm(geometry));
  matrix[3] = glm::dvec4(geometry.origin_patient_mm, 1.0);
  return matrix;
}

glm::dmat4 patient_to_index(const VolumeGeometry& geometry) {
  const glm::dmat3 inverse = glm::inverse(axes_patient_mm(geometry));
  glm::dmat4 matrix(inverse);
  matrix[3] = glm::dvec4(-(inverse * geometry.origin_patient_mm), 1.0);
  return matrix;
}

VolumeGeometry part_of(const VolumeGeometry& geometry, glm::ivec3 first, glm::ivec3 last) {
  VolumeGeometry part = geometry;
  part.size_voxels = last - first + 1;
  part.origin_patient_mm = glm::dvec3(index_to_patient(geometry) * glm::dvec4(first, 1.0));
  return part;
}

BoundingBox bounds_patient_mm(const VolumeGeometry& geometry) {
  const glm::dmat3 axes = axes_patient_mm(geometry);
  BoundingBox bounds{geometry.origin_patient_mm, geometry.origin_patient_mm};
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 extent = axes[axis] * double(geometry.size_voxels[axis] - 1);
    bounds.minimum_mm += glm::min(extent, 0.0);
    bounds.maximum_mm += glm::max(extent, 0.0);
  }
  return bounds;
}

bool is_within_reach(glm::dvec3 position_mm) {
  return glm::all(glm::lessThanEqual(glm::abs(position_mm), glm::dvec3(kFarthestPosition_mm)));
}

bool is_within_reach(const VolumeGeometry& geometry) {
  const BoundingBox bounds = bounds_patient_mm(geometry);
  return is_within_reach(bounds.minimum_mm) && is_within_reach(bounds.maximum_mm);
}

double smallest_spacing_mm(const VolumeGeometry& geometry) {
  const glm::dvec3 spacing = geometry.spacing_mm;
  return std::min({spacing.x, spacing.y, spacing.z});
}

double diagonal_mm(const VolumeGeometry& geometry) {
  return glm::length(glm::dvec3(geometry.size_voxels - 1) * geometry.spacing_mm);
}

glm::dmat3 half_axes_mm(const VolumeGeometry& geometry) {
  const glm::dvec3 half_mm = 0.5 * glm::dvec3(geometry.size_voxels) * geometry.spacing_mm;
  glm::dmat3 axes = geometry.direction_patient;
  for (int axis = 0; axis < 3; ++axis) axes[axis] *= half_mm[axis];
  return axes;
}

glm::dvec3 centre_mm(const VolumeGeometry& geometry) {
  const glm::dvec3 middle = 0.5 * glm::dvec3(geometry.size_voxels - 1);
  return {index_to_patient(geometry) * glm::dvec4(middle, 1.0)};
}

glm::dvec3 middle_voxel_mm(const VolumeGeometry& geometry) {
  const glm::ivec3 index = geometry.size_voxels / 2;
  return {index_to_patient(geometry) * glm::dvec4(index, 1.0)};
}

}  // namespace cutaway
