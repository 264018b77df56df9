#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

/// `count` slices of a ramp, `step` apart, in files whose names and instance numbers run against
/// their places.
std::vector<DicomSlice> ramp_series(int count, glm::dvec3 first, glm::dvec3 step,
                                    const DicomSlice& like = {}) {
  std::vector<DicomSlice> slices;
  for (int k = 0; k < count; ++k) {
    DicomSlice& slice = slices.emplace_back(like);
    slice.position_mm = first + step * static_cast<double>(k);
    slice.texts[{0x0020, 0x0013}] = std::to_string((k * 7) % count);
    slice.fill_with_ramp();
  }
  return slices;
}

void write_series(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices,
                  const std::string& prefix = "") {
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const std::size_t scrambled = (k * 5 + 3) % slices.size();
    write_dicom(
        folder / (prefix + std::to_string(1000 + scrambled) + "-" + std::to_string(k) + ".dcm"),
        slices[k]);
  }
}

DicomSlice ramp_slice(glm::dvec3 row, glm::dvec3 column) {
  DicomSlice slice;
  slice.size_px = {7, 5};
  slice.spacing_mm = {0.75, 1.25};
  slice.row_axis = glm::normalize(row);
  slice.column_axis = glm::normalize(column - slice.row_axis * glm::dot(slice.row_axis, column));
  slice.slope = 0.125;
  slice.intercept = 900;
  return slice;
}

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

TEST(Dicom, AWideGapIsRefused) {
  std::vector<DicomSlice> slices = ramp_series(20, {0, 0, 0}, {0, 0, 1});
  slices.erase(slices.begin() + 6, slices.begin() + 14);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const std::string reason = only_refusal(folder.path());
  EXPECT_NE(reason.find("a gap of 9 mm"), std::string::npos) << reason;
}

std::vector<DicomSlice> with_text(std::vector<DicomSlice> slices, DicomTag tag,
                                  const std::string& text) {
  for (auto& slice : slices) slice.texts[tag] = text;
  return slices;
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

TEST(Dicom, SlicesThatNothingTellsApartAreRefused) {
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}), "a");
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}), "b");
  EXPECT_NE(only_refusal(folder.path()).find("lie at the same place"), std::string::npos);
}

TEST(Dicom, CopiesOfAnInstanceCountOnce) {
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}));
  const auto original = std::filesystem::directory_iterator(folder.path())->path();
  std::filesystem::create_directory(folder / "again");
  std::filesystem::copy_file(original, folder / "again/copy.dcm");
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels.z, 4);
  EXPECT_TRUE(has_warning(volume.description, "1 slices are copies"));
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

class DicomSyntax : public testing::TestWithParam<Syntax> {};

TEST_P(DicomSyntax, Decodes) {
  DicomSlice like = ramp_slice({1, 0, 0}, {0, 1, 0});
  like.size_px = {32, 16};
  like.bits_stored = 12;
  like.is_signed = false;
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(3, {0, 0, 0}, {0, 0, 2}, like));
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    transcode(entry.path(), GetParam());
  expect_ramp(read_only_volume(folder.path()), 0.2);
}

INSTANTIATE_TEST_SUITE_P(All, DicomSyntax,
                         testing::Values(Syntax::implicit, Syntax::big_endian, Syntax::deflated,
                                         Syntax::rle, Syntax::jpeg_lossless, Syntax::jpeg_ls,
                                         Syntax::jpeg_2000));

TEST(Dicom, EachSlicesOwnRescaleIsAppliedOnce) {
  auto slices = ramp_series(4, {0, 0, 0}, {0, 0, 2});
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].slope = 0.5 + 0.25 * static_cast<double>(k);
    slices[k].intercept = -10.0 * static_cast<double>(k);
    slices[k].fill_with_ramp();
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  expect_ramp(read_only_volume(folder.path()), 0.7);
}

/// 12 bits stored, two's complement, with an overlay's rubbish above.
TEST(Dicom, OnlyTheStoredBitsCount) {
  auto slices = ramp_series(2, {0, 0, 0}, {0, 0, 2});
  for (auto& slice : slices) {
    slice.bits_stored = 12;
    for (std::size_t i = 0; i < slice.stored.size(); ++i) {
      slice.stored[i] = static_cast<std::int16_t>(i % 2 == 0 ? 0x4FFF : 0x3005);
    }
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {0, 0, 0}), -1);
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 5);
}

TEST(Dicom, DescribesItselfWithoutThePatient) {
  TemporaryFolder folder;
  write_series(folder / "a b", with_text(ramp_series(3, {0, 0, 0}, {0, 0, 2}), {0x0008, 0x103e},
                                         "Sch\xE4"
                                         "del 1.0"));
  const VolumeDescription description = only_source(folder.path(), folder.path()).description;
  EXPECT_EQ(description.title,
            "Sch\xC3\xA4"
            "del 1.0");
  EXPECT_EQ(description.format, "DICOM");
  EXPECT_EQ(description.modality, "CT");
  EXPECT_EQ(description.units, "HU");
  EXPECT_TRUE(description.id.starts_with("a-b~")) << description.id;
  EXPECT_EQ((description.title + description.id).find("Secret"), std::string::npos);
}

TEST(Dicom, OtherModalitiesHaveNoHounsfieldUnits) {
  TemporaryFolder folder;
  DicomSlice like;
  like.modality = "MR";
  write_series(folder.path(), ramp_series(3, {0, 0, 0}, {0, 0, 2}, like));
  EXPECT_EQ(read_only_volume(folder.path()).description.units, "none");
}

TEST(EnhancedDicom, FollowsEachFramesPlaceAndRescale) {
  auto frames = ramp_series(5, {3, 4, 50}, {0, 0, -2}, ramp_slice({1, 0, 0}, {0, 1, 0}));
  std::swap(frames[1], frames[3]);
  frames[2].slope = 0.25;
  frames[2].fill_with_ramp();
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "enhanced.dcm", frames);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(7, 5, 5));
  EXPECT_NEAR(volume.geometry.origin_patient_mm.z, 42, 1e-6);
  EXPECT_EQ(volume.description.id, "enhanced.dcm");
  expect_ramp(volume, 0.2);
}

TEST(EnhancedDicom, TimesAreToldApart) {
  const auto first = ramp_series(3, {0, 0, 0}, {0, 0, 2}, ramp_slice({1, 0, 0}, {0, 1, 0}));
  auto frames = first;
  for (auto frame : first) {
    std::fill(frame.stored.begin(), frame.stored.end(), static_cast<std::int16_t>(40));
    frames.push_back(frame);
  }
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "4d.dcm", frames, {1, 1, 1, 2, 2, 2});
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  expect_ramp(read(listing.volumes[0]), 0.2);
  const Volume second = read(listing.volumes[1]);
  EXPECT_EQ(second.value_range, (ValueRange{905, 905}));
}

TEST(EnhancedDicom, AWrongNumberOfFramesIsRefused) {
  auto frames = ramp_series(3, {0, 0, 0}, {0, 0, 2});
  frames[0].texts[{0x0028, 0x0008}] = "4";
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "e.dcm", frames);
  EXPECT_NE(only_refusal(folder.path()).find("number of frames is unclear"), std::string::npos);
}

TEST(Dicom, SeveralFramesWithoutTheirPlacesAreRefused) {
  DicomSlice slice;
  slice.stored.assign(32, 1);
  slice.texts[{0x0028, 0x0008}] = "2";
  TemporaryFolder folder;
  write_dicom(folder / "cine.dcm", slice);
  EXPECT_NE(only_refusal(folder.path()).find("several frames"), std::string::npos);
}

struct BrokenSlice {
  const char* name;
  DicomTag tag;
  const char* text;
  const char* reason;
};

class BrokenDicom : public testing::TestWithParam<BrokenSlice> {};

TEST_P(BrokenDicom, EachFileIsListedWithItsReason) {
  TemporaryFolder folder;
  write_series(folder.path(),
               with_text(ramp_series(2, {0, 0, 0}, {0, 0, 2}), GetParam().tag, GetParam().text));
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.volumes.empty());
  ASSERT_FALSE(listing.refused.empty());
  EXPECT_NE(listing.refused[0].reason.find(GetParam().reason), std::string::npos)
      << listing.refused[0].reason;
}

INSTANTIATE_TEST_SUITE_P(
    Headers, BrokenDicom,
    testing::Values(BrokenSlice{"no_position", {0x0020, 0x0032}, "", "ImagePositionPatient"},
                    BrokenSlice{"nan_position",
                                {0x0020, 0x0032},
                                "0\\nan\\3",
                                "ImagePositionPatient; expected 3 finite numbers; got 0, nan, 3"},
                    BrokenSlice{"no_orientation", {0x0020, 0x0037}, "", "ImageOrientationPatient"},
                    BrokenSlice{"zero_spacing", {0x0028, 0x0030}, "0\\1", "spacing is not usable"},
                    BrokenSlice{
                        "negative_spacing", {0x0028, 0x0030}, "1\\-1", "spacing is not usable"},
                    BrokenSlice{"text_spacing", {0x0028, 0x0030}, "one\\1", "PixelSpacing"},
                    BrokenSlice{"colour", {0x0028, 0x0004}, "RGB", "colour"},
                    BrokenSlice{"mosaic", {0x0008, 0x0008}, "ORIGINAL\\PRIMARY\\MOSAIC", "mosaic"},
                    BrokenSlice{"same_place", {0x0020, 0x0032}, "1\\2\\3", "same place"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Dicom, OneCutOffSliceIsListedAndTheOthersAreRead) {
  TemporaryFolder folder;
  DicomSlice like;
  like.size_px = {64, 64};
  write_series(folder.path(), ramp_series(8, {0, 0, 0}, {0, 0, 2}, like));
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::filesystem::resize_file(files[4], 3000);
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, files[4]);
  EXPECT_FALSE(listing.refused[0].reason.empty());
  ASSERT_EQ(listing.volumes.size(), 1U);
  EXPECT_EQ(listing.volumes[0].files.size(), 7U);
}

TEST(Dicom, ACutOffCompressedSliceFailsWithItsName) {
  TemporaryFolder folder;
  DicomSlice like;
  like.size_px = {64, 64};
  write_series(folder.path(), ramp_series(3, {0, 0, 0}, {0, 0, 2}, like));
  std::filesystem::path last;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    last = entry.path();
    transcode(last, Syntax::jpeg_ls);
  }
  std::filesystem::resize_file(last, std::filesystem::file_size(last) - 300);
  const Listing listing = scan(folder.path());
  const bool refused_at_once = !listing.refused.empty();
  if (!refused_at_once) {
    ASSERT_EQ(listing.volumes.size(), 1U);
    EXPECT_NE(read_failure(listing.volumes[0]).find(last.filename().string()), std::string::npos);
  }
}

TEST(Dicom, GarbageUnderADicomNameIsRefused) {
  TemporaryFolder folder;
  write_file(folder / "a.dcm", "");
  write_file(folder / "b.dcm", std::string(3000, 'x'));
  write_file(folder / "c", std::string(128, '\0') + "DICM" + std::string(300, '\xFF'));
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.volumes.empty());
  EXPECT_EQ(listing.refused.size(), 3U);
}

TEST(Dicom, TheByteLimitHoldsBeforeDecoding) {
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}));
  const Listing listing = scan_volumes(folder.path(), folder.path(), {.volume_bytes = 100}, {});
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_NE(listing.refused[0].reason.find("too large"), std::string::npos);
}

TEST(Dicom, StopsBetweenSlicesAndReportsOnTheWay) {
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(6, {0, 0, 0}, {0, 0, 2}));
  const VolumeSource source = only_source(folder.path(), folder.path());
  std::vector<std::pair<LoadStage, double>> heard;
  read_volume(source, {}, [&](LoadStage stage, double f) { heard.emplace_back(stage, f); }, {});
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  EXPECT_EQ(heard.front(), (std::pair{LoadStage::read, 0.0}));
  EXPECT_EQ(heard.back(), (std::pair{LoadStage::decode, 1.0}));
  EXPECT_GE(heard.size(), 12U);
  std::stop_source stop;
  const auto stop_at_decoding = [&](LoadStage stage, double) {
    if (stage == LoadStage::decode) stop.request_stop();
  };
  EXPECT_THROW(read_volume(source, {}, stop_at_decoding, stop.get_token()), Cancelled);
  EXPECT_THROW(scan_volumes(folder.path(), folder.path(), {}, stop.get_token()), Cancelled);
}

}  // namespace
}  // namespace cutaway::test
