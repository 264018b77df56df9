#include "support/analytic_volumes.h"

#include <cmath>

#include "volume/voxel_packing.h"

namespace cutaway::test {

VolumeGeometry centred_geometry(int size) {
  return centred_geometry(glm::ivec3(size), glm::dvec3(1.0));
}

VolumeGeometry centred_geometry(glm::ivec3 size, glm::dvec3 spacing_mm,
                                const glm::dmat3& direction) {
  const glm::dvec3 half_mm = 0.5 * spacing_mm * glm::dvec3(size - 1);
  return {.size_voxels = size,
          .spacing_mm = spacing_mm,
          .origin_patient_mm = -(direction * half_mm),
          .direction_patient = direction};
}

glm::dmat3 oblique_direction() {
  const glm::dvec3 k = glm::normalize(glm::dvec3(0.3, -0.2, 0.9));
  const glm::dvec3 i = glm::normalize(glm::cross(glm::dvec3(0.1, 1.0, 0.2), k));
  return {i, glm::cross(k, i), k};
}

glm::dmat3 flipped_direction() {
  return {glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)};
}

double QuadraticField::value(glm::dvec3 x) const {
  return constant + glm::dot(linear, x) + glm::dot(x, quadratic * x);
}

glm::dvec3 QuadraticField::gradient_per_mm(glm::dvec3 x) const {
  return linear + (quadratic + glm::transpose(quadratic)) * x;
}

double ShellField::value(glm::dvec3 x) const {
  const double per_mm = (skin_iso_hu - bone_iso_hu) / (skin_radius_mm - bone_radius_mm);
  return skin_iso_hu + per_mm * (glm::length(x) - skin_radius_mm);
}

Volume sampled_volume(const VolumeGeometry& geometry,
                      const std::function<double(glm::dvec3)>& value_at_mm) {
  const glm::ivec3 size = geometry.size_voxels;
  const glm::dmat4 to_patient = index_to_patient(geometry);
  std::vector<float> values;
  values.reserve(std::size_t(size.x) * size.y * size.z);
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        const glm::dvec3 position_mm(to_patient * glm::dvec4(i, j, k, 1.0));
        values.push_back(float(value_at_mm(position_mm)));
      }
    }
  }
  PackedVoxels packed = pack_voxels(std::span<const float>(values));
  return {.description = {.id = "analytic",
                          .title = "Analytic",
                          .format = "phantom",
                          .modality = "CT",
                          .units = "HU",
                          .warnings = {}},
          .geometry = geometry,
          .voxels = std::move(packed.voxels),
          .value_scale = packed.value_scale,
          .value_offset = packed.value_offset,
          .value_range = packed.value_range};
}

Volume sphere_volume(const VolumeGeometry& geometry, double value_at_centre, glm::dvec3 centre_mm) {
  return sampled_volume(geometry,
                        [&](glm::dvec3 x) { return value_at_centre - glm::length(x - centre_mm); });
}

Volume quadratic_volume(const VolumeGeometry& geometry, const QuadraticField& field) {
  return sampled_volume(geometry, [&](glm::dvec3 x) { return field.value(x); });
}

Volume shells_volume(const VolumeGeometry& geometry, const ShellField& field) {
  return sampled_volume(geometry, [&](glm::dvec3 x) { return field.value(x); });
}

Volume slab_volume(const VolumeGeometry& geometry, const SlabField& field) {
  return sampled_volume(geometry, [&](glm::dvec3 x) {
    const double depth_mm = std::abs(glm::dot(x, field.normal));
    return depth_mm <= field.half_thickness_mm ? field.inside : field.outside;
  });
}

Volume torus_volume(const VolumeGeometry& geometry, double major_radius_mm,
                    double minor_radius_mm) {
  return sampled_volume(geometry, [&](glm::dvec3 x) {
    const double from_circle = glm::length(glm::dvec2(x)) - major_radius_mm;
    return minor_radius_mm - glm::length(glm::dvec2(from_circle, x.z));
  });
}

Volume constant_volume(const VolumeGeometry& geometry, double value) {
  return sampled_volume(geometry, [&](glm::dvec3) { return value; });
}

}  // namespace cutaway::test
