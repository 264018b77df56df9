// Which planes make a volume, in which order, on which grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

struct Acquisition {
  const char* name;
  glm::dvec3 row;
  glm::dvec3 column;
};

class DicomOrientation : public testing::TestWithParam<Acquisition> {};

TEST_P(DicomOrientation, FollowsTheHeaderIntoThePatient) {
  const DicomSlice like = ramp_slice(GetParam().row, GetParam().column);
  const glm::dvec3 normal = glm::cross(like.row_axis, like.column_axis);
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(6, {-20, 30, 10}, normal * -2.5, like));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(volume.description.warnings.empty());
  EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(7, 5, 6));
  EXPECT_NEAR(volume.geometry.spacing_mm.x, 0.75, 1e-9);
  EXPECT_NEAR(volume.geometry.spacing_mm.y, 1.25, 1e-9);
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 2.5, 1e-6);
  EXPECT_NEAR(glm::dot(volume.geometry.direction_patient[2], normal), 1, 1e-6)
      << "sorted along +normal";
  expect_ramp(volume, 0.07);
}

INSTANTIATE_TEST_SUITE_P(Acquisitions, DicomOrientation,
                         testing::Values(Acquisition{"axial", {1, 0, 0}, {0, 1, 0}},
                                         Acquisition{"axial_prone", {-1, 0, 0}, {0, -1, 0}},
                                         Acquisition{"axial_from_above", {-1, 0, 0}, {0, 1, 0}},
                                         Acquisition{"coronal", {1, 0, 0}, {0, 0, -1}},
                                         Acquisition{"sagittal", {0, 1, 0}, {0, 0, -1}},
                                         Acquisition{"oblique", {0.9, 0.3, -0.2}, {0.1, 0.8, 0.5}}),
                         [](const auto& test) { return std::string(test.param.name); });

/// The gantry leans: slices stay axial in their own plane, but are stacked along the table.
TEST(Dicom, GantryTiltIsResampledToARightGrid) {
  const double tilt = 18.0 * 3.14159265358979 / 180;
  DicomSlice like = ramp_slice({1, 0, 0}, {0, std::cos(tilt), std::sin(tilt)});
  like.size_px = {12, 24};
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(9, {5, 6, 7}, {0, 0, 3}, like));
  const VolumeSource source = only_source(folder.path(), folder.path());
  const Volume volume = read(source);
  EXPECT_TRUE(has_warning(volume.description, "sheared by 18.0 degrees"));
  EXPECT_TRUE(has_warning(volume.description, "resampled"));
  EXPECT_EQ(source.geometry, volume.geometry);
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 3 * std::cos(tilt), 1e-6);
  EXPECT_NEAR(glm::dot(volume.geometry.direction_patient[1], volume.geometry.direction_patient[2]),
              0, 1e-9);
  EXPECT_GT(volume.geometry.size_voxels.y, 24);
  expect_ramp(volume, 0.2, 0.35);
}

TEST(Dicom, MissingSlicesAreInterpolatedAndSaid) {
  std::vector<DicomSlice> slices =
      ramp_series(12, {0, 0, 0}, {0, 0, 2}, ramp_slice({1, 0, 0}, {0, 1, 0}));
  slices.erase(slices.begin() + 5, slices.begin() + 7);
  slices.erase(slices.begin() + 2);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "3 slices are missing"));
  EXPECT_EQ(volume.geometry.size_voxels.z, 12);
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 2, 1e-9);
  expect_ramp(volume, 0.2);
}

TEST(Dicom, UnevenSlicesAreResampledAndSaid) {
  std::vector<DicomSlice> slices;
  for (const double z : {0.0, 1.0, 2.0, 3.0, 4.0, 5.5, 7.0, 8.5, 10.0}) {
    DicomSlice& slice = slices.emplace_back(ramp_slice({1, 0, 0}, {0, 1, 0}));
    slice.position_mm = {0, 0, z};
    slice.fill_with_ramp();
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "resampled"));
  EXPECT_GE((volume.geometry.size_voxels.z - 1) * volume.geometry.spacing_mm.z, 10 - 1e-6);
  // The last step may reach beyond the last slice, whose values then go on.
  Volume inner = volume;
  expect_ramp(inner, 0.2 + 5.0 * volume.geometry.spacing_mm.z);
}

TEST(Dicom, RoundedPositionsAreEven) {
  std::vector<DicomSlice> slices;
  for (int k = 0; k < 20; ++k) {
    DicomSlice& slice = slices.emplace_back(ramp_slice({1, 0, 0}, {0, 1, 0}));
    slice.position_mm = {0, 0, std::round(k * 0.625 * 100) / 100};
    slice.fill_with_ramp();
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(volume.description.warnings.empty());
  EXPECT_EQ(volume.geometry.size_voxels.z, 20);
}

/// In any direction, as some writers round them: no tilt, and no uneven distances.
TEST(Dicom, PositionsRoundedToATenthOfAMillimetreAreStraightAndEven) {
  for (const double step : {0.625, 1.25, 3.3}) {
    DicomSlice like = ramp_slice({0.9, 0.3, -0.2}, {0.1, 0.8, 0.5});
    const glm::dvec3 normal = glm::cross(like.row_axis, like.column_axis);
    auto slices = ramp_series(40, {-20.04, 30.07, 10.01}, normal * step, like);
    for (auto& slice : slices) slice.position_mm = glm::round(slice.position_mm * 10.0) / 10.0;
    TemporaryFolder folder;
    write_series(folder.path(), slices);
    const Volume volume = read_only_volume(folder.path());
    EXPECT_TRUE(volume.description.warnings.empty()) << volume.description.warnings.front();
    EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(7, 5, 40));
    EXPECT_NEAR(volume.geometry.spacing_mm.z, step, 0.01);
  }
}

/// What digits cannot explain is still said, and not as a tilt of nothing.
TEST(Dicom, SlicesThatLieAboutAreShifted) {
  auto slices = ramp_series(9, {0.001, 0, 0}, {0, 0, 3});
  for (std::size_t k = 1; k < slices.size(); k += 2) slices[k].position_mm.x += 0.8;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "shifted against each other by up to 0.8 mm"));
}

TEST(Dicom, OneMissingSliceIsCalledOne) {
  auto slices = ramp_series(12, {0, 0, 0}, {0, 0, 2});
  slices.erase(slices.begin() + 5);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  EXPECT_TRUE(has_warning(read_only_volume(folder.path()).description, "1 slice is missing"));
}

/// Fine at first, and every eighth millimetre then: several gaps in a row are no hole.
TEST(Dicom, AWideSpacingBehindAFineOneIsRead) {
  auto slices = ramp_series(10, {0, 0, 0}, {0, 0, 1});
  for (const auto& slice : ramp_series(5, {0, 0, 17}, {0, 0, 8})) slices.push_back(slice);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "changes from 1 to 8 mm"));
  EXPECT_EQ(volume.geometry.size_voxels.z, 50);
  expect_ramp(volume, 0.6);
}

TEST(Dicom, AWideGapIsRefused) {
  std::vector<DicomSlice> slices = ramp_series(20, {0, 0, 0}, {0, 0, 1});
  slices.erase(slices.begin() + 6, slices.begin() + 14);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const std::string reason = only_refusal(folder.path());
  EXPECT_NE(reason.find("a gap of 9 mm"), std::string::npos) << reason;
}

struct Part {
  const char* name;
  DicomTag tag;
  const char* first;
  const char* second;
  const char* title_of_second;
};

class DicomParts : public testing::TestWithParam<Part> {};

/// Two stacks at the same places in one series are two volumes.
TEST_P(DicomParts, AreToldApart) {
  const auto stack = ramp_series(4, {0, 0, 0}, {0, 0, 2}, ramp_slice({1, 0, 0}, {0, 1, 0}));
  DicomSlice other = ramp_slice({1, 0, 0}, {0, 1, 0});
  other.intercept = 0;
  TemporaryFolder folder;
  write_series(folder.path(), with_text(stack, GetParam().tag, GetParam().first), "a");
  write_series(
      folder.path(),
      with_text(ramp_series(4, {0, 0, 0}, {0, 0, 2}, other), GetParam().tag, GetParam().second),
      "b");
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.refused.empty());
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_NE(listing.volumes[0].description.id, listing.volumes[1].description.id);
  bool titled = false;
  for (const auto& source : listing.volumes) {
    titled =
        titled || source.description.title.find(GetParam().title_of_second) != std::string::npos;
    EXPECT_EQ(source.files.size(), 4U);
    const Volume volume = read(source);
    EXPECT_EQ(volume.geometry, source.geometry);
    expect_ramp(volume, 0.2);
    for (const char c : source.description.id)
      EXPECT_TRUE(std::isalnum(c) || std::strchr("._-/~", c)) << c;
  }
  EXPECT_TRUE(titled);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, DicomParts,
    testing::Values(
        Part{"echo", {0x0018, 0x0086}, "1", "2", "(echo 2)"},
        Part{"time", {0x0020, 0x0100}, "1", "2", "(time 2)"},
        Part{"echo_time", {0x0018, 0x0081}, "4.6", "12.5", "(echo time 12.5)"},
        Part{"acquisition", {0x0020, 0x0012}, "3", "10", "(acquisition 10)"},
        Part{"image_type", {0x0008, 0x0008}, "DERIVED\\PRIMARY\\W", "DERIVED\\PRIMARY\\F", "F)"},
        Part{
            "acquisition_time", {0x0008, 0x0032}, "101500", "101530", "(acquisition time 101530)"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Dicom, OrientationsInOneSeriesAreToldApart) {
  TemporaryFolder folder;
  write_series(folder.path(),
               ramp_series(4, {0, 0, 0}, {0, 0, 2}, ramp_slice({1, 0, 0}, {0, 1, 0})), "a");
  write_series(folder.path(),
               ramp_series(5, {0, 0, 0}, {0, 2, 0}, ramp_slice({1, 0, 0}, {0, 0, -1})), "c");
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  for (const auto& source : listing.volumes) expect_ramp(read(source), 0.2);
}

TEST(Dicom, SeriesInNestedAndMixedFoldersAreGroupedByTheirUid) {
  TemporaryFolder folder;
  DicomSlice other = ramp_slice({1, 0, 0}, {0, 1, 0});
  other.series_uid = "1.2.826.2";
  const auto one = ramp_series(6, {0, 0, 0}, {0, 0, 2});
  write_series(folder / "mixed/deep", {one[0], one[2], one[4]}, "x");
  write_series(folder / "mixed", {one[1], one[3], one[5]}, "y");
  write_series(folder / "mixed", ramp_series(4, {0, 0, 0}, {0, 0, 2}, other), "z");
  write_file(folder / "mixed/readme.txt", "not an image");
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.refused.empty());
  ASSERT_EQ(listing.volumes.size(), 2U);
  std::vector<int> slices;
  for (const auto& source : listing.volumes) {
    EXPECT_TRUE(source.description.id.starts_with("mixed~")) << source.description.id;
    slices.push_back(read(source).geometry.size_voxels.z);
  }
  std::sort(slices.begin(), slices.end());
  EXPECT_EQ(slices, (std::vector{4, 6}));
}

}  // namespace
}  // namespace cutaway::test
