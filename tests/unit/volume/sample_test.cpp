#include <gtest/gtest.h>

#include <random>

#include "support/analytic_volumes.h"
#include "volume/volume.h"

namespace cutaway {
namespace {

Volume counting_volume() {
  std::vector<std::uint16_t> stored(2 * 3 * 4);
  for (std::size_t i = 0; i < stored.size(); ++i) stored[i] = std::uint16_t(i);
  Volume volume;
  volume.geometry.size_voxels = {2, 3, 4};
  volume.voxels = stored;
  volume.value_scale = 2.0;
  volume.value_offset = -1000.0;
  return volume;
}

TEST(ValueAt, RescalesOnceAndCountsIFastest) {
  const Volume volume = counting_volume();
  EXPECT_EQ(value_at(volume, {0, 0, 0}), -1000.0);
  EXPECT_EQ(value_at(volume, {1, 0, 0}), -998.0);
  EXPECT_EQ(value_at(volume, {0, 1, 0}), -996.0);
  EXPECT_EQ(value_at(volume, {0, 0, 1}), -988.0);
}

TEST(ValueAt, ClampsTheIndex) {
  const Volume volume = counting_volume();
  EXPECT_EQ(value_at(volume, {-5, 0, 0}), value_at(volume, {0, 0, 0}));
  EXPECT_EQ(value_at(volume, {9, 9, 9}), value_at(volume, {1, 2, 3}));
}

TEST(Sample, IsExactOnALinearField) {
  const test::QuadraticField field{.constant = 12.0, .linear = {3.0, -0.5, 0.25}};
  const VolumeGeometry geometry =
      test::centred_geometry({17, 23, 11}, test::kAnisotropicSpacingMm, test::oblique_direction());
  const Volume volume = test::quadratic_volume(geometry, field);
  const glm::dmat4 to_patient = index_to_patient(geometry);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 index =
        glm::dvec3(unit(random), unit(random), unit(random)) * glm::dvec3(16.0, 22.0, 10.0);
    const glm::dvec3 position_mm(to_patient * glm::dvec4(index, 1.0));
    EXPECT_NEAR(sample(volume, index), field.value(position_mm), 1e-5);  // voxels are floats
  }
}

TEST(Sample, ClampsBeyondTheGridAndIsExactAtVoxels) {
  const Volume volume = counting_volume();
  EXPECT_EQ(sample(volume, {-4.0, -1.0, -0.1}), value_at(volume, {0, 0, 0}));
  EXPECT_EQ(sample(volume, {7.0, 2.9, 3.5}), value_at(volume, {1, 2, 3}));
  EXPECT_EQ(sample(volume, {1.0, 2.0, 3.0}), value_at(volume, {1, 2, 3}));
}

TEST(ByteSize, IsThatOfTheStoredType) {
  EXPECT_EQ(byte_size(counting_volume()), 48u);
  EXPECT_EQ(byte_size(test::constant_volume(test::centred_geometry(4), 1.0)), 256u);
}

}  // namespace
}  // namespace cutaway
