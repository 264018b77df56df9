// Where voxels are in the patient.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace cutaway {

/// Of a coordinate from the patient's origin. A scene's camera and lens have the same limit
/// (scene.schema.json): what lies beyond it could never be looked at.
inline constexpr double kFarthestPosition_mm = 100'000.0;

/// A regular grid in patient space: DICOM's LPS (x to the patient's left, y to posterior, z to
/// superior), millimetres. Voxel centres are at integer indices. Axes are orthogonal; the grid may
/// be oblique, anisotropic and left-handed.
struct VolumeGeometry {
  glm::ivec3 size_voxels{0};
  glm::dvec3 spacing_mm{1.0};
  glm::dvec3 origin_patient_mm{0.0};  ///< centre of voxel (0,0,0)
  glm::dmat3 direction_patient{1.0};  ///< unit columns: the i, j and k axes in patient space

  bool operator==(const VolumeGeometry&) const = default;
};

struct BoundingBox {
  glm::dvec3 minimum_mm{0.0};
  glm::dvec3 maximum_mm{0.0};
  bool operator==(const BoundingBox&) const = default;
};

glm::dmat4 index_to_patient(const VolumeGeometry& geometry);
glm::dmat4 patient_to_index(const VolumeGeometry& geometry);

/// The grid of the voxels from `first` to `last`, both included.
VolumeGeometry part_of(const VolumeGeometry& geometry, glm::ivec3 first, glm::ivec3 last);

/// Axis-aligned patient-space bounds of the voxel centres.
BoundingBox bounds_patient_mm(const VolumeGeometry& geometry);

/// Whether each coordinate is a number within kFarthestPosition_mm.
bool is_within_reach(glm::dvec3 position_mm);

/// Whether all voxel centres are.
bool is_within_reach(const VolumeGeometry& geometry);

/// Columns: from the grid's centre to the middle of a face, along the i, j and k axes. A face lies
/// half a voxel beyond the outermost centres.
glm::dmat3 half_axes_mm(const VolumeGeometry& geometry);

glm::dvec3 centre_mm(const VolumeGeometry& geometry);
/// Centre of the voxel in the middle: where an axis has an even number of them, of the later of
/// two.
glm::dvec3 middle_voxel_mm(const VolumeGeometry& geometry);

/// In its unit rays count their steps.
double smallest_spacing_mm(const VolumeGeometry& geometry);

/// Length of the grid's diagonal between the centres of opposite corner voxels.
double diagonal_mm(const VolumeGeometry& geometry);

}  // namespace cutaway
