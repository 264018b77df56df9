// Numbers that stand for "nothing here" beside tissue, in volumes that are resampled.
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr int kWidth = 6;
constexpr int kHeight = 32;
constexpr int kSlices = 9;
constexpr double kTissue = 40.0;
constexpr double kAir = -1000.0;

/// Nothing, then tissue, then air, along each column.
template <typename T>
std::vector<T> columns(T nothing) {
  std::vector<T> values;
  for (int k = 0; k < kSlices; ++k) {
    for (int j = 0; j < kHeight; ++j)
      values.insert(values.end(), kWidth, j < 8 ? nothing : T(j < 20 ? kTissue : kAir));
  }
  return values;
}

/// Each slice is half a pixel further down, so that every other one is mixed in halves.
template <typename T>
Volume read_tilted(const std::string& type, T nothing) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd", "NRRD0004\ntype: " + type +
                                    "\ndimension: 3\nspace: LPS\nsizes: 6 32 9\n"
                                    "space directions: (1,0,0) (0,1,0) (0,0.5,2)\n"
                                    "space origin: (0,0,0)\nendian: little\nencoding: raw\n\n" +
                                    bytes_of_numbers(columns(nothing)));
  Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "resampled"));
  return volume;
}

/// How often each value is there.
std::map<double, int> values_in(const Volume& volume) {
  std::map<double, int> counts;
  const glm::ivec3 size = volume.geometry.size_voxels;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) ++counts[value_at(volume, {i, j, k})];
    }
  }
  return counts;
}

/// Where tissue and air meet, and only there, are values of neither: once a column of four slices.
void expect_unmixed(const Volume& volume, double nothing) {
  std::map<double, int> counts = values_in(volume);
  EXPECT_GE(counts[nothing], kWidth * kSlices * 7);
  EXPECT_GE(counts[kTissue], kWidth * kSlices * 11);
  EXPECT_EQ(counts[(kTissue + kAir) / 2], kWidth * (kSlices / 2));
  for (const auto& [value, count] : counts) {
    const bool is_known =
        value == nothing || value == kTissue || value == kAir || value == (kTissue + kAir) / 2;
    EXPECT_TRUE(is_known) << count << " voxels have the value " << value;
  }
}

TEST(Resampling, PaddingOfScannersIsNotMixedWithTissue) {
  expect_unmixed(read_tilted<std::int16_t>("int16", -2000), -2000);
  expect_unmixed(read_tilted<std::int16_t>("int16", -3024), -3024);
  expect_unmixed(read_tilted<float>("float", -3024), -3024);
}

TEST(Resampling, NumbersForNothingStayNothing) {
  for (const Volume& volume :
       {read_tilted<std::int16_t>("int16", -32768), read_tilted<float>("float", -32768),
        read_tilted<float>("float", std::numeric_limits<float>::lowest())}) {
    ASSERT_TRUE(volume.nothing_value);
    expect_unmixed(volume, *volume.nothing_value);
    EXPECT_EQ(volume.value_range.minimum, kAir);
  }
}

/// What no slice covers has the smallest value, which is not what has none.
TEST(Resampling, HolesOfNaNStayHoles) {
  const Volume volume = read_tilted<float>("float", std::numeric_limits<float>::quiet_NaN());
  ASSERT_TRUE(volume.nothing_value);
  expect_unmixed(volume, *volume.nothing_value);
}

/// A declared padding becomes the smallest value, but is no part of a mean.
TEST(Resampling, DeclaredPaddingIsNotMixedWithTissue) {
  DicomSlice like;
  like.size_px = {kWidth, kHeight};
  like.shorts = {{{0x0028, 0x0120}, 77, true}};
  const std::vector<std::int16_t> values = columns<std::int16_t>(77);
  std::vector<DicomSlice> slices(kSlices, like);
  for (int k = 0; k < kSlices; ++k) {
    slices[k].position_mm = {0, 0.5 * k, 2.0 * k};
    const auto first = values.begin() + std::ptrdiff_t{kWidth} * kHeight * k;
    slices[k].stored.assign(first, first + std::ptrdiff_t{kWidth} * kHeight);
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "are padding"));
  EXPECT_TRUE(has_warning(volume.description, "resampled"));
  expect_unmixed(volume, kAir);
}

/// A number is no sentinel for being the smallest: what has neighbours is mixed as ever.
TEST(Resampling, AirIsMixedWithTissue) {
  std::map<double, int> counts = values_in(read_tilted<std::int16_t>("int16", -1100));
  EXPECT_EQ(counts[(kTissue - 1100) / 2], kWidth * (kSlices / 2));
}

}  // namespace
}  // namespace cutaway::test
