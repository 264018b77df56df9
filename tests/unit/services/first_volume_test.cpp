#include "services/first_volume.h"

#include <gtest/gtest.h>

namespace cutaway {
namespace {

double worth(const char* id, const char* modality, glm::ivec3 size, glm::dvec3 spacing_mm) {
  VolumeDescription description;
  description.id = id;
  description.modality = modality;
  VolumeGeometry geometry;
  geometry.size_voxels = size;
  geometry.spacing_mm = spacing_mm;
  return worth_seeing(description, geometry);
}

TEST(WorthSeeing, IsGreatestForALargeCt) {
  const double chest = worth("chest", "CT", {512, 512, 275}, {0.8, 0.8, 1.0});
  const double slab = worth("a/slab", "CT", {512, 512, 3}, {0.8, 0.8, 1.0});
  const double thick = worth("thick", "CT", {512, 512, 40}, {0.8, 0.8, 8.0});
  const double small = worth("small", "CT", {120, 100, 110}, {3.0, 3.0, 3.0});
  const double labels = worth("a/ct.labels.nii.gz", "", {512, 512, 275}, {0.8, 0.8, 1.0});
  const double head = worth("head", "MR", {160, 232, 160}, {1.0, 0.9, 0.9});
  for (const double other : {slab, thick, small, labels, head}) EXPECT_GT(chest, other);
  EXPECT_GT(small, labels);
  EXPECT_GT(head, slab);
  EXPECT_LE(chest, 1.0);
  EXPECT_GT(slab, 0.0);
}

}  // namespace
}  // namespace cutaway
