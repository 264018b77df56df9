// What one file holds: pixels in every syntax, enhanced frames, broken headers.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

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

/// Several threads share the series, its voxels and its padding.
TEST_P(DicomSyntax, DecodesSlicesSideBySide) {
  constexpr int kSlices = 80;
  DicomSlice like;
  like.size_px = {9, 7};
  like.shorts = {{{0x0028, 0x0120}, -32000, true}};
  auto slices = ramp_series(kSlices, {0, 0, 0}, {0, 0, 2}, like);
  for (auto& slice : slices) slice.stored.back() = -32000;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    transcode(entry.path(), GetParam());
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, std::to_string(kSlices) + " pixels are padding"));
  for (int k = 0; k < kSlices; ++k) {
    const auto& stored = slices[static_cast<std::size_t>(k)].stored;
    EXPECT_EQ(value_at(volume, {8, 6, k}), volume.value_range.minimum) << k;
    for (int i = 0; i < 62; ++i)
      EXPECT_EQ(value_at(volume, {i % 9, i / 9, k}), stored[static_cast<std::size_t>(i)]) << k;
  }
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

TEST(Dicom, TheFirstOfItsWindowsIsKept) {
  const auto window_with = [](const char* centres, const char* widths) {
    TemporaryFolder folder;
    auto slices = with_text(ramp_series(3, {0, 0, 0}, {0, 0, 2}), {0x0028, 0x1050}, centres);
    write_series(folder.path(), with_text(std::move(slices), {0x0028, 0x1051}, widths));
    return only_source(folder.path(), folder.path()).description.window;
  };
  EXPECT_EQ(window_with("50\\-600", "350\\1500"), (ValueRange{-125.0, 225.0}));
  EXPECT_EQ(window_with("50", "0"), std::nullopt);
  EXPECT_EQ(window_with("middle", "350"), std::nullopt);
  EXPECT_EQ(window_with("", ""), std::nullopt);
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

/// One frame at a time is decoded, so that the limit is of each volume.
TEST(EnhancedDicom, FramesAreDecodedOneByOne) {
  std::vector<DicomSlice> frames(6);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].position_mm = {0, 0, static_cast<double>(i % 2)};
    frames[i].fill_with_ramp();
  }
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "times.dcm", frames, {1, 1, 2, 2, 3, 3});
  const std::uint64_t volume_bytes = 2 * 4 * 4 * 2;
  const Listing listing =
      scan_volumes(folder.path(), folder.path(), {.volume_bytes = volume_bytes}, {});
  ASSERT_EQ(listing.volumes.size(), 3U);
  EXPECT_EQ(listing.volumes[0].decode_bytes, volume_bytes / 2);
  for (const auto& source : listing.volumes) expect_ramp(read(source), 0.6);
}

TEST_P(DicomSyntax, DecodesEnhancedFrames) {
  DicomSlice like;
  like.size_px = {32, 16};
  auto frames = ramp_series(5, {3, 4, 50}, {0, 0, -2}, like);
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "enhanced.dcm", frames);
  transcode(folder / "enhanced.dcm", GetParam());
  expect_ramp(read_only_volume(folder.path()), 0.2);
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
  EXPECT_GE(heard.size(), 8U);  // 6 files read, and the share of the decoding that this thread does
  std::stop_source stop;
  const auto stop_at_decoding = [&](LoadStage stage, double) {
    if (stage == LoadStage::decode) stop.request_stop();
  };
  EXPECT_THROW(read_volume(source, {}, stop_at_decoding, stop.get_token()), Cancelled);
  EXPECT_THROW(scan_volumes(folder.path(), folder.path(), {}, stop.get_token()), Cancelled);
}

}  // namespace
}  // namespace cutaway::test
