// Volumes whose surfaces, normals and integrals are known in closed form.
#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "volume/volume.h"

namespace cutaway::test {

/// Size N^3 with spacing (1,1,1), centre of the grid at the origin of patient space.
VolumeGeometry centred_geometry(int size);

/// The same centre with any size, spacing and direction.
VolumeGeometry centred_geometry(glm::ivec3 size, glm::dvec3 spacing_mm,
                                const glm::dmat3& direction = glm::dmat3(1.0));

inline constexpr glm::dvec3 kAnisotropicSpacingMm{1.0, 0.7, 2.0};

/// A rotation about a skew axis; determinant +1.
glm::dmat3 oblique_direction();

/// The i and k axes run against x and z, and i and j are exchanged: determinant -1.
glm::dmat3 flipped_direction();

// Positions are patient space, mm; voxels are floats, as pack_voxels stores them; modality CT,
// units HU.

/// f = value_at_centre - distance from `centre_mm`: iso-value a is the sphere of radius
/// value_at_centre - a.
Volume sphere_volume(const VolumeGeometry& geometry, double value_at_centre,
                     glm::dvec3 centre_mm = glm::dvec3(0.0));

/// f = constant + linear . x + x . (quadratic x).
struct QuadraticField {
  double constant = 0.0;
  glm::dvec3 linear{0.0};
  glm::dmat3 quadratic{0.0};

  double value(glm::dvec3 x) const;
  glm::dvec3 gradient_per_mm(glm::dvec3 x) const;
};
Volume quadratic_volume(const VolumeGeometry& geometry, const QuadraticField& field);

/// Concentric spheres of "skin" and "bone" about the origin.
struct ShellField {
  double skin_radius_mm = 40.0;
  double bone_radius_mm = 25.0;
  double skin_iso_hu = -200.0;
  double bone_iso_hu = 250.0;

  /// Linear in the distance from the origin: skin_iso at skin_radius, bone_iso at bone_radius.
  double value(glm::dvec3 x) const;
};
Volume shells_volume(const VolumeGeometry& geometry, const ShellField& field = {});

/// `inside` where |x . normal| <= half_thickness_mm, else `outside`; no ramp between.
struct SlabField {
  glm::dvec3 normal{0.0, 0.0, 1.0};
  double half_thickness_mm = 8.0;
  double inside = 500.0;
  double outside = -1000.0;
};
Volume slab_volume(const VolumeGeometry& geometry, const SlabField& field = {});

/// f = minor_radius_mm - distance from the circle of major_radius_mm about z: iso-value 0 is the
/// torus.
Volume torus_volume(const VolumeGeometry& geometry, double major_radius_mm, double minor_radius_mm);

Volume constant_volume(const VolumeGeometry& geometry, double value);

/// Any function of the position.
Volume sampled_volume(const VolumeGeometry& geometry,
                      const std::function<double(glm::dvec3)>& value_at_mm);

}  // namespace cutaway::test
