// What a stored number means, and which window shows it.
#include <gtest/gtest.h>

#include <limits>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

std::vector<DicomSlice> slices_of(int count, const DicomSlice& like) {
  std::vector<DicomSlice> slices(static_cast<std::size_t>(count), like);
  for (std::size_t k = 0; k < slices.size(); ++k)
    slices[k].position_mm = {0, 0, 2.0 * static_cast<double>(k)};
  return slices;
}

Volume volume_of(const std::vector<DicomSlice>& slices) {
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  return read_only_volume(folder.path());
}

/// Falling, as of a film: what is stored high means little.
DicomSlice with_table(const std::string& type) {
  DicomSlice slice;
  slice.modality = "MR";
  slice.table = {.first_stored = 10, .entries = {}, .type = type};
  for (int i = 0; i < 251; ++i)
    slice.table.entries.push_back(static_cast<std::uint16_t>(4000 - 16 * i));
  for (int i = 0; i < 16; ++i) slice.stored.push_back(static_cast<std::int16_t>(20 * i));
  return slice;
}

TEST(DicomValues, AModalityTableIsLookedUp) {
  const Volume volume = volume_of(slices_of(3, with_table("US")));
  EXPECT_EQ(value_at(volume, {0, 0, 1}), 4000) << "below the first entry";
  EXPECT_EQ(value_at(volume, {1, 0, 1}), 4000 - 16 * 10);
  EXPECT_EQ(value_at(volume, {3, 1, 1}), 4000 - 16 * 130);
  EXPECT_EQ(value_at(volume, {3, 3, 1}), 0) << "above the last entry";
  EXPECT_EQ(volume.description.units, "none");
}

TEST(DicomValues, SignedPixelsAndPaddingGoThroughTheTable) {
  DicomSlice slice = with_table("HU");
  slice.modality = "CT";
  slice.table.first_stored = -100;
  slice.stored[0] = -100;
  slice.stored[1] = -2000;
  slice.shorts = {{{0x0028, 0x0120}, -2000, true}};
  const Volume volume = volume_of(slices_of(2, slice));
  EXPECT_EQ(value_at(volume, {0, 0, 0}), 4000);
  EXPECT_EQ(value_at(volume, {1, 0, 0}), volume.value_range.minimum) << "padding";
  EXPECT_EQ(volume.description.units, "HU");
}

TEST(DicomValues, TablesThatDifferAreAppliedEachToItsSlice) {
  auto slices = slices_of(2, with_table("US"));
  slices[1].table.entries.assign(251, 7);
  const Volume volume = volume_of(slices);
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 3840);
  EXPECT_EQ(value_at(volume, {1, 0, 1}), 7);
}

TEST(DicomValues, ATableOfOneEntryIsOne) {
  auto slices = slices_of(2, with_table("US"));
  for (auto& slice : slices) slice.table.entries.resize(1);
  slices[1].table.entries[0] = 5;
  const Volume volume = volume_of(slices);
  EXPECT_EQ(value_at(volume, {3, 3, 0}), 4000);
  EXPECT_EQ(value_at(volume, {0, 0, 1}), 5);
}

TEST(DicomValues, AnEnhancedFilesCommonRescaleIsApplied) {
  DicomSlice like;
  like.intercept = -1024;
  auto frames = ramp_series(4, {0, 0, 0}, {0, 0, 2}, like);
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "e.dcm", frames, {}, true);
  const Volume volume = read_only_volume(folder.path());
  expect_ramp(volume, 0.6);
  EXPECT_EQ(volume.description.units, "HU");
}

TEST(DicomValues, CtWithoutARescaleIsNotCalledHounsfield) {
  DicomSlice like;
  like.has_rescale = false;
  const Volume volume = volume_of(ramp_series(3, {0, 0, 0}, {0, 0, 2}, like));
  EXPECT_EQ(volume.description.units, "none");
  EXPECT_TRUE(has_warning(volume.description, "gives no rescale"));
}

struct Unit {
  const char* modality;
  DicomTag tag;
  const char* term;
  const char* shown;
};

TEST(DicomValues, UnitsThatAreStatedAreShown) {
  constexpr DicomTag kRescaleType{0x0028, 0x1054};
  constexpr DicomTag kPetUnits{0x0054, 0x1001};
  for (const Unit& unit :
       {Unit{"CT", kRescaleType, "HU", "HU"}, Unit{"CT", kRescaleType, "US", "none"},
        Unit{"CT", kRescaleType, "HU_MOD", "HU_MOD"}, Unit{"PT", kPetUnits, "BQML", "BQML"},
        Unit{"PT", kPetUnits, "CNTS", "CNTS"}, Unit{"MR", kRescaleType, "normalized", "none"}}) {
    DicomSlice like;
    like.modality = unit.modality;
    const auto slices = ramp_series(3, {0, 0, 0}, {0, 0, 2}, like);
    EXPECT_EQ(volume_of(with_text(slices, unit.tag, unit.term)).description.units, unit.shown)
        << unit.term;
  }
}

/// As of diffusion coefficients; the windows of such a file are of its stored values.
TEST(DicomValues, ARealWorldMappingCountsWhereThereIsNoRescale) {
  DicomSlice like;
  like.modality = "MR";
  like.mapping = {.slope = 0.5, .intercept = -10, .unit = "mm2/s"};
  for (int i = 0; i < 16; ++i) like.stored.push_back(static_cast<std::int16_t>(100 * i));
  like.texts = {{{0x0028, 0x1050}, "800"}, {{0x0028, 0x1051}, "400"}};
  const Volume rescaled = volume_of(slices_of(2, like));
  EXPECT_EQ(value_at(rescaled, {3, 3, 1}), 1500) << "the rescale holds";
  like.has_rescale = false;
  const Volume mapped = volume_of(slices_of(2, like));
  EXPECT_EQ(value_at(mapped, {3, 3, 1}), 740);
  EXPECT_EQ(mapped.description.units, "mm2/s");
  EXPECT_EQ(mapped.description.window, (ValueRange{290, 490}));
}

TEST(DicomValues, FloatAndDoublePixelsAreRead) {
  for (const bool is_double : {false, true}) {
    auto slices = ramp_series(4, {3, 4, 5}, {0, 0, 2});
    for (auto& slice : slices) {
      for (const auto value : slice.stored) {
        if (is_double) slice.doubles.push_back(value + 0.25);
        if (!is_double) slice.floats.push_back(static_cast<float>(value) + 0.25F);
      }
    }
    slices[0].floats.resize(is_double ? 0 : 16);
    const Volume volume = volume_of(slices);
    EXPECT_NEAR(volume.geometry.origin_patient_mm.x, 3, 1e-9);
    EXPECT_NEAR(value_at(volume, {2, 1, 3}), slices[3].stored[6] + 0.25, 1e-3);
    expect_ramp(volume, 0.8);
  }
}

TEST(DicomValues, AZeroSlopeIsRefused) {
  DicomSlice like;
  like.stored.assign(16, 5);
  auto slices = slices_of(2, like);
  for (auto& slice : slices) slice.slope = 0;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Listing listing = scan(folder.path());
  ASSERT_FALSE(listing.refused.empty());
  EXPECT_NE(listing.refused[0].reason.find("rescale"), std::string::npos);
}

/// A slice of `value` in its right half, with a window of its own.
DicomSlice windowed(int value, const char* centre, const char* width) {
  DicomSlice slice;
  slice.modality = "MR";
  for (int i = 0; i < 16; ++i)
    slice.stored.push_back(static_cast<std::int16_t>(i % 4 < 2 ? i : value + i));
  slice.texts[{0x0028, 0x1050}] = centre;
  slice.texts[{0x0028, 0x1051}] = width;
  return slice;
}

Volume volume_with_windows(const std::vector<DicomSlice>& slices) {
  auto placed = slices;
  for (std::size_t k = 0; k < placed.size(); ++k)
    placed[k].position_mm = {0, 0, 2.0 * static_cast<double>(k)};
  return volume_of(placed);
}

TEST(DicomWindow, IsThatOfAMiddleSlice) {
  const DicomSlice empty = windowed(4, "8", "12");
  const DicomSlice full = windowed(900, "520", "1040");
  EXPECT_EQ(volume_with_windows({empty, empty, full, full, full}).description.window,
            (ValueRange{0, 1040}));
  EXPECT_EQ(volume_with_windows({full, full, full, empty}).description.window,
            (ValueRange{0, 1040}));
}

TEST(DicomWindow, ComesFromTheNearestSliceThatHasOne) {
  const DicomSlice full = windowed(900, "520", "1040");
  DicomSlice silent = full;
  silent.texts.clear();
  EXPECT_EQ(volume_with_windows({full, silent, silent, silent, silent}).description.window,
            (ValueRange{0, 1040}));
}

TEST(DicomWindow, ThatShowsNothingIsLeftOutAndSaid) {
  for (const char* centre : {"-3000", "400", "30000"}) {
    const DicomSlice slice = windowed(900, centre, "100");
    const Volume volume = volume_with_windows({slice, slice, slice});
    EXPECT_EQ(volume.description.window, std::nullopt) << centre;
    EXPECT_TRUE(has_warning(volume.description, "shows nothing of its values"));
  }
}

}  // namespace
}  // namespace cutaway::test
