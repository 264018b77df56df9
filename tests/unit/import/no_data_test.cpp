// Values that are none: numbers that stand for no value, NaN, and single hot voxels.
#include <gtest/gtest.h>

#include <limits>

#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"
#include "volume/loaded_volume.h"

namespace cutaway::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

enum : std::int16_t { kInt16 = 4, kInt32 = 8, kFloat = 16, kUint16 = 512 };

template <typename T>
Volume read_values(std::int16_t datatype, std::vector<T> values, double slope = 0) {
  TemporaryFolder folder;
  NiftiFile file{.dim = {10, 10, 10}, .datatype = datatype, .slope = slope};
  write_file(folder / "a.nii", file.with(bytes_of_numbers(values)));
  return read_only_volume(folder / "a.nii");
}

/// Air, body and bone, with some other value in every tenth voxel of the first half.
template <typename T>
std::vector<T> head_with(T other, T air = T(-1000), T body = T(40), T bone = T(700)) {
  std::vector<T> values(1000, air);
  std::fill(values.begin() + 300, values.end(), body);
  std::fill(values.begin() + 800, values.end(), bone);
  for (std::size_t i = 0; i < 500; i += 10) values[i] = other;
  return values;
}

template <typename T>
void expect_head(const Volume& volume, T other) {
  SCOPED_TRACE(double(other));
  EXPECT_EQ(volume.value_range, (ValueRange{-1000.0, 700.0}));
  EXPECT_EQ(value_at(volume, {0, 0, 0}), volume.nothing_value);
  EXPECT_EQ(value_at(volume, {1, 0, 0}), -1000.0);
  EXPECT_LT(*volume.nothing_value, -1000.0);
  EXPECT_EQ(volume.description.units, "HU");
  EXPECT_TRUE(has_warning(volume.description, "50 voxels"));
  EXPECT_TRUE(has_warning(volume.description, "counts as nothing"));
}

TEST(NoData, CustomNumbersFarFromAllOthersAreNothing) {
  for (const float other : {-kLargest, kLargest, -1e30f, 1e20f, 9.96921e36f, -9999.0f, -32768.0f,
                            -99999.0f, kNan, -std::numeric_limits<float>::infinity()})
    expect_head(read_values(kFloat, head_with(other)), other);
  for (const std::int16_t other : {std::int16_t{-32768}, std::int16_t{-9999}})
    expect_head(read_values(kInt16, head_with(other)), other);
  for (const std::int32_t other :
       {std::numeric_limits<std::int32_t>::min(), -99999, std::numeric_limits<std::int32_t>::max()})
    expect_head(read_values(kInt32, head_with(other)), other);
}

TEST(NoData, IsFoundBeforeTheRescale) {
  const Volume volume = read_values(kInt16, head_with<std::int16_t>(-32768, -500, 20, 350), 2.0);
  expect_head(volume, -32768);
}

TEST(NoData, UnsignedNumbersHaveRoomBelowZero) {
  const Volume volume = read_values(kUint16, head_with<std::uint16_t>(65535, 0, 40, 700));
  EXPECT_EQ(volume.value_range, (ValueRange{0.0, 700.0}));
  EXPECT_EQ(volume.nothing_value, -1.0);
}

TEST(NoData, NumbersWithNeighboursAreValues) {
  std::vector<std::int16_t> ramp(1000);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = std::int16_t(-32768 + 65 * int(i));
  EXPECT_EQ(read_values(kInt16, ramp).value_range.minimum, -32768.0);
  std::vector<float> deep(1000);
  for (std::size_t i = 0; i < deep.size(); ++i) deep[i] = -9999.0f + 10.0f * float(i);
  EXPECT_EQ(read_values(kFloat, deep).value_range.minimum, -9999.0);
}

TEST(NoData, MasksOfTheLargestNumberAreValues) {
  std::vector<std::uint16_t> mask(1000, 0);
  std::fill(mask.begin() + 400, mask.end(), 65535);
  EXPECT_EQ(read_values(kUint16, mask).value_range, (ValueRange{0.0, 65535.0}));
  for (std::size_t i = 0; i < 100; ++i) mask[i] = 1;
  EXPECT_EQ(read_values(kUint16, mask).value_range, (ValueRange{0.0, 65535.0}));
}

/// SPM and FSL write NaN outside of what they label.
TEST(NoData, ABodyOfTheSmallestLabelIsNotWhatIsOutsideOfIt) {
  std::vector<float> labels(1000, kNan);
  std::fill(labels.begin() + 500, labels.end(), 1.0f);
  std::fill(labels.begin() + 900, labels.end(), 2.0f);
  const auto loaded = derive_loaded_volume(read_values(kFloat, labels), {}, {});
  EXPECT_EQ(loaded->volume.value_range, (ValueRange{1.0, 2.0}));
  EXPECT_EQ(loaded->volume.nothing_value, 0.0);
  EXPECT_NEAR(loaded->findings.outer.value, 0.5, 0.01);
  EXPECT_NEAR(loaded->findings.inner.value, 0.5, 0.01);
}

TEST(HotVoxel, ChangesNothingThatIsChosen) {
  std::vector<float> values = head_with(-1000.0f);
  values[555] = 1e6f;
  const auto loaded = derive_loaded_volume(read_values(kFloat, values), {}, {});
  EXPECT_EQ(loaded->volume.description.units, "HU");
  EXPECT_EQ(loaded->volume.value_range.maximum, 1e6);
  EXPECT_EQ(loaded->histogram.range, (ValueRange{-1000.0, 700.0}));
  EXPECT_EQ(loaded->findings.outer.value, -300.0);
  EXPECT_EQ(loaded->findings.inner.value, 250.0);
  EXPECT_TRUE(has_warning(loaded->volume.description, "1 voxel lies far from all others"));
}

TEST(EmptyVolume, SaysThatItIsEmpty) {
  const Volume volume = read_values(kFloat, std::vector<float>(1000, 3.0f));
  EXPECT_TRUE(has_warning(volume.description, "every voxel has the value 3: the volume is empty"));
}

}  // namespace
}  // namespace cutaway::test
