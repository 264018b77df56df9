#include "volume/usual_values.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/analytic_volumes.h"
#include "volume/loaded_volume.h"
#include "volume/voxel_packing.h"

namespace cutaway {
namespace {

/// A head of CT values: air, skin, bone; whatever else is set into it.
Volume head_with(const std::vector<float>& others) {
  Volume volume = test::sphere_volume(test::centred_geometry(24), 6.0);
  volume.description = {};
  auto& voxels = std::get<std::vector<float>>(volume.voxels);
  for (float& voxel : voxels) voxel = voxel > 0.0f ? 700.0f : voxel > -3.0f ? 40.0f : -1000.0f;
  for (std::size_t i = 0; i < others.size(); ++i) voxels[101 * i] = others[i];
  PackedVoxels packed = pack_voxels(std::span<const float>(voxels));
  volume.voxels = std::move(packed.voxels);
  volume.value_scale = packed.value_scale;
  volume.value_offset = packed.value_offset;
  volume.value_range = packed.value_range;
  return volume;
}

SuggestedSurfaces surfaces_of(const Volume& volume) {
  return suggest_surfaces(build_histogram(volume, 1024));
}

TEST(UsualValues, AreAllWhereNoneIsAStray) {
  const UsualValues usual = usual_values(head_with({}));
  EXPECT_EQ(usual.range, (ValueRange{-1000.0, 700.0}));
  EXPECT_EQ(usual.strays, 0u);
}

TEST(UsualValues, LeaveOutHotAndDeadVoxels) {
  for (const std::vector<float>& strays :
       {std::vector{1e6f}, std::vector{1e6f, 2e5f, -1e5f}, std::vector{-3e30f}, std::vector{1e20f},
        std::vector(10, 1e5f)}) {
    const Volume volume = head_with(strays);
    const UsualValues usual = usual_values(volume);
    EXPECT_EQ(usual.range, (ValueRange{-1000.0, 700.0}));
    EXPECT_EQ(usual.strays, strays.size());
    const SuggestedSurfaces without = surfaces_of(head_with({}));
    EXPECT_NEAR(surfaces_of(volume).outer_iso_value, without.outer_iso_value, 20.0);
    EXPECT_NEAR(surfaces_of(volume).inner_iso_value, without.inner_iso_value, 20.0);
    const ValueRange window = suggest_window(volume.description, build_histogram(volume, 1024));
    EXPECT_NEAR(window.minimum, -1000.0, 5.0);
    EXPECT_NEAR(window.maximum, 700.0, 5.0);
  }
}

/// A stent is bright, but not beyond everything.
TEST(UsualValues, KeepWhatIsRareButNear) {
  const UsualValues usual = usual_values(head_with({3071.0f, 3071.0f}));
  EXPECT_EQ(usual.range.maximum, 3071.0);
  EXPECT_EQ(usual.strays, 0u);
}

TEST(UsualValues, KeepASmallObjectInAnEmptyVolume) {
  Volume volume = test::constant_volume(test::centred_geometry(20), 0.0);
  auto& voxels = std::get<std::vector<float>>(volume.voxels);
  voxels[4000] = 1.0f;
  voxels[4001] = 900.0f;
  volume.value_range = {0.0, 900.0};
  EXPECT_EQ(usual_values(volume).range, volume.value_range);
}

TEST(UsualValues, CountNothingAsAValue) {
  std::vector<float> labels(1000, std::numeric_limits<float>::quiet_NaN());
  std::fill(labels.begin(), labels.begin() + 400, 1.0f);
  std::fill(labels.begin(), labels.begin() + 100, 2.0f);
  PackedVoxels packed = pack_voxels(std::span<const float>(labels));
  Volume volume;
  volume.geometry = test::centred_geometry(10);
  volume.voxels = std::move(packed.voxels);
  volume.value_range = packed.value_range;
  volume.nothing_value = packed.nothing_value;
  EXPECT_EQ(usual_values(volume).range, (ValueRange{0.0, 2.0}));
  EXPECT_NEAR(surfaces_of(volume).outer_iso_value, 0.5, 0.01);
  EXPECT_NEAR(surfaces_of(volume).inner_iso_value, 1.5, 0.01);
}

/// More voxels than are looked at, as integers.
TEST(UsualValues, OfALargeVolumeAreThoseOfItsSamples) {
  Volume volume = test::constant_volume(test::centred_geometry({128, 128, 64}, {1, 1, 1}), 0.0);
  std::vector<std::uint16_t> voxels(std::size_t{128} * 128 * 64);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t(i % 128);
  voxels[777] = 60000;
  volume.voxels = voxels;
  volume.value_scale = 2.0;
  volume.value_range = {0.0, 120000.0};
  const UsualValues usual = usual_values(volume);
  EXPECT_EQ(usual.range, (ValueRange{0.0, 254.0}));
  EXPECT_EQ(usual.strays, 1u);
}

}  // namespace
}  // namespace cutaway
