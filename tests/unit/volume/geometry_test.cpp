#include "volume/geometry.h"

#include <gtest/gtest.h>

#include "support/analytic_volumes.h"

namespace cutaway {
namespace {

using test::centred_geometry;
using test::flipped_direction;
using test::kAnisotropicSpacingMm;
using test::oblique_direction;

glm::dvec3 apply(const glm::dmat4& matrix, glm::dvec3 p) {
  return glm::dvec3(matrix * glm::dvec4(p, 1.0));
}

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

class EveryOrientation : public testing::TestWithParam<glm::dmat3> {
 protected:
  VolumeGeometry geometry() const {
    VolumeGeometry g = centred_geometry({40, 50, 20}, kAnisotropicSpacingMm, GetParam());
    g.origin_patient_mm += glm::dvec3(-201.0, 59.5, -679.8);
    return g;
  }
};

TEST_P(EveryOrientation, IndexToPatientAndBackIsTheSamePlace) {
  const glm::dmat4 there = index_to_patient(geometry());
  const glm::dmat4 back = patient_to_index(geometry());
  for (const glm::dvec3 index : {glm::dvec3(0.0), {39.0, 49.0, 19.0}, {-3.5, 80.25, 7.125}}) {
    expect_near(apply(back, apply(there, index)), index, 1e-10);
  }
}

TEST_P(EveryOrientation, TheVoxelInTheMiddleIsHalfAVoxelFromTheCentreWhereTheirNumberIsEven) {
  const VolumeGeometry g = geometry();
  expect_near(middle_voxel_mm(g), apply(index_to_patient(g), {20.0, 25.0, 10.0}), 1e-9);
  VolumeGeometry odd = g;
  odd.size_voxels = {41, 51, 21};
  expect_near(middle_voxel_mm(odd), centre_mm(odd), 1e-9);
}

TEST_P(EveryOrientation, OneVoxelAlongAnAxisIsItsSpacingAlongItsDirection) {
  const VolumeGeometry g = geometry();
  const glm::dmat4 there = index_to_patient(g);
  expect_near(apply(there, glm::dvec3(0.0)), g.origin_patient_mm, 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = 1.0;
    expect_near(apply(there, step) - g.origin_patient_mm, g.spacing_mm[axis] * GetParam()[axis],
                1e-12);
  }
}

TEST_P(EveryOrientation, BoundsAreTightAboutTheCornerVoxels) {
  const VolumeGeometry g = geometry();
  const BoundingBox bounds = bounds_patient_mm(g);
  glm::dvec3 lowest(1e9);
  glm::dvec3 highest(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 index(corner & 1 ? 39 : 0, corner & 2 ? 49 : 0, corner & 4 ? 19 : 0);
    const glm::dvec3 position = apply(index_to_patient(g), index);
    lowest = glm::min(lowest, position);
    highest = glm::max(highest, position);
  }
  expect_near(bounds.minimum_mm, lowest, 1e-10);
  expect_near(bounds.maximum_mm, highest, 1e-10);
}

TEST_P(EveryOrientation, DiagonalJoinsOppositeCornerVoxels) {
  const VolumeGeometry g = geometry();
  const glm::dmat4 there = index_to_patient(g);
  const double length = glm::length(apply(there, {39, 49, 19}) - apply(there, glm::dvec3(0.0)));
  EXPECT_NEAR(diagonal_mm(g), length, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Geometry, EveryOrientation,
                         testing::Values(glm::dmat3(1.0), oblique_direction(),
                                         flipped_direction()));

}  // namespace
}  // namespace cutaway
