// Slices that are there twice, and slices that only seem to be.
#include <gtest/gtest.h>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr DicomTag kInstanceUid{0x0008, 0x0018};
constexpr DicomTag kInstanceNumber{0x0020, 0x0013};

std::vector<DicomSlice> ramp() { return ramp_series(10, {0, 0, 0}, {0, 0, 2}); }

TEST(DicomCopies, WithTheSameIdentifierCountOnce) {
  TemporaryFolder folder;
  write_series(folder.path(), ramp_series(4, {0, 0, 0}, {0, 0, 2}));
  const auto original = std::filesystem::directory_iterator(folder.path())->path();
  std::filesystem::create_directory(folder / "again");
  std::filesystem::copy_file(original, folder / "again/copy.dcm");
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels.z, 4);
  EXPECT_TRUE(has_warning(volume.description, "1 slice is a copy of another"));
}

/// Exported twice: identifiers and the time of the export are new.
TEST(DicomCopies, WithNewIdentifiersCountOnce) {
  TemporaryFolder folder;
  write_series(folder / "a", with_text(ramp(), {0x0008, 0x0033}, "101500"));
  write_series(folder / "b", with_text(ramp(), {0x0008, 0x0033}, "173000"));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels.z, 10);
  EXPECT_TRUE(has_warning(volume.description, "10 slices are copies of others"));
  expect_ramp(volume, 0.6);
}

TEST(DicomCopies, WithNewNumbersCountOnceWhereEverySliceIsOne) {
  auto copies = ramp();
  for (std::size_t k = 0; k < copies.size(); ++k)
    copies[k].texts[kInstanceNumber] = std::to_string(k + 11);
  TemporaryFolder folder;
  write_series(folder.path(), ramp(), "a");
  write_series(folder.path(), copies, "b");
  EXPECT_EQ(read_only_volume(folder.path()).geometry.size_voxels.z, 10);
}

TEST(DicomCopies, PackedInAnotherWayCountOnce) {
  TemporaryFolder folder;
  write_series(folder / "a", ramp());
  write_series(folder / "b", ramp());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "b"))
    transcode(entry.path(), Syntax::jpeg_ls);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels.z, 10);
  expect_ramp(volume, 0.6);
}

TEST(DicomCopies, AreSaidOfTheVolumeThatHasThem) {
  TemporaryFolder folder;
  write_series(folder.path(), with_text(ramp(), {0x0018, 0x0086}, "1"), "a");
  write_series(folder.path(), with_text(ramp(), {0x0018, 0x0086}, "2"), "b");
  write_series(folder.path(), with_text(ramp(), {0x0018, 0x0086}, "2"), "c");
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  for (const auto& source : listing.volumes) {
    const bool is_second = source.description.title.find("echo 2") != std::string::npos;
    EXPECT_EQ(has_warning(source.description, "are copies"), is_second);
  }
}

TEST(DicomCopies, AreNotSlicesThatShareAnIdentifier) {
  for (const std::size_t sharing : {2, 10}) {
    auto slices = ramp();
    for (std::size_t k = 0; k < slices.size(); ++k)
      slices[k].texts[kInstanceUid] = "1.2.3.4." + std::to_string(k / sharing);
    TemporaryFolder folder;
    write_series(folder.path(), slices);
    const Volume volume = read_only_volume(folder.path());
    EXPECT_TRUE(volume.description.warnings.empty());
    EXPECT_EQ(volume.geometry.size_voxels.z, 10);
    expect_ramp(volume, 0.6);
  }
}

/// At the same places, but with other pixels.
TEST(DicomCopies, AreNotStacksThatNothingTellsApart) {
  auto others = ramp();
  for (auto& slice : others)
    for (auto& value : slice.stored) value = static_cast<std::int16_t>(value + 1);
  TemporaryFolder folder;
  write_series(folder.path(), ramp(), "a");
  write_series(folder.path(), others, "b");
  EXPECT_NE(only_refusal(folder.path()).find("lie at the same place"), std::string::npos);
}

}  // namespace
}  // namespace cutaway::test
