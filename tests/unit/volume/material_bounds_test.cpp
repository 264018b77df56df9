#include <gtest/gtest.h>

#include "support/analytic_volumes.h"
#include "volume/loaded_volume.h"

namespace cutaway {
namespace {

TEST(MaterialBounds, HoldTheMaterialToABrick) {
  const glm::dvec3 centre_mm(20.0, -10.0, 5.0);
  for (const auto& direction : {glm::dmat3(1.0), test::flipped_direction()}) {
    const auto geometry = test::centred_geometry(glm::ivec3(128), glm::dvec3(1.0), direction);
    const Volume volume = test::sphere_volume(geometry, 20.0, centre_mm);
    const MinMaxGrid grid = build_min_max_grid(volume, 8, {}, {});
    const BoundingBox bounds = bounds_reaching_mm(grid, geometry, 0.0);  // a sphere of radius 20
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(bounds.minimum_mm[axis], centre_mm[axis] - 20.0);
      EXPECT_GE(bounds.minimum_mm[axis], centre_mm[axis] - 29.0);
      EXPECT_GE(bounds.maximum_mm[axis], centre_mm[axis] + 20.0);
      EXPECT_LE(bounds.maximum_mm[axis], centre_mm[axis] + 29.0);
    }
  }
}

TEST(MaterialBounds, AreTheGridsWhereNothingReachesTheValue) {
  const auto geometry = test::centred_geometry(40);
  const auto loaded = derive_loaded_volume(test::constant_volume(geometry, -1000.0), {}, {});
  EXPECT_EQ(loaded->material_bounds_mm, bounds_patient_mm(geometry));
}

}  // namespace
}  // namespace cutaway
