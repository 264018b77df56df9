// Padding around the image must not count as values of it.
#include <gtest/gtest.h>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr DicomTag kPaddingValue{0x0028, 0x0120};
constexpr DicomTag kPaddingLimit{0x0028, 0x0121};

/// A CT of 10 to 1500 stored, with -1024 as its intercept.
DicomSlice ct_slice(double z_mm) {
  DicomSlice slice;
  slice.position_mm = {0, 0, z_mm};
  slice.intercept = -1024;
  for (int i = 0; i < 16; ++i) slice.stored.push_back(static_cast<std::int16_t>(10 + 100 * i));
  slice.stored[15] = 1500;
  return slice;
}

struct Padding {
  const char* name;
  bool pixels_are_signed;
  std::vector<DicomShort> declared;
  std::vector<int> stored;  ///< at the first pixels
  std::size_t padded;       ///< how many of those are padding
};

void PrintTo(const Padding& padding, std::ostream* out) { *out << padding.name; }

std::vector<DicomSlice> padded_series(const Padding& padding) {
  std::vector<DicomSlice> slices{ct_slice(0), ct_slice(2)};
  for (auto& slice : slices) {
    slice.is_signed = padding.pixels_are_signed;
    slice.shorts = padding.declared;
  }
  for (std::size_t i = 0; i < padding.stored.size(); ++i)
    slices[0].stored[i] = static_cast<std::int16_t>(padding.stored[i]);
  return slices;
}

class DicomPadding : public testing::TestWithParam<Padding> {};

TEST_P(DicomPadding, BecomesTheSmallestRealValue) {
  TemporaryFolder folder;
  write_series(folder.path(), padded_series(GetParam()));
  const Volume volume = read_only_volume(folder.path());
  const std::size_t padded = GetParam().padded;
  for (int i = 0; i < static_cast<int>(padded); ++i)
    EXPECT_EQ(value_at(volume, {i, 0, 0}), volume.value_range.minimum) << i;
  for (std::size_t i = padded; i < GetParam().stored.size(); ++i)
    EXPECT_EQ(value_at(volume, {static_cast<int>(i), 0, 0}), GetParam().stored[i] - 1024.0) << i;
  EXPECT_GE(volume.value_range.minimum, -30999 - 1024) << "padding is no value";
  EXPECT_EQ(volume.value_range.maximum, 1500 - 1024);
  EXPECT_TRUE(has_warning(volume.description, std::to_string(padded) + " pixels are padding"));
}

INSTANTIATE_TEST_SUITE_P(
    Declarations, DicomPadding,
    testing::Values(
        Padding{"signed", true, {{kPaddingValue, -32000, true}}, {-32000, -32000}, 2},
        Padding{"signed_pixels_declared_unsigned",
                true,
                {{kPaddingValue, 65536 - 32000, false}},
                {-32000},
                1},
        Padding{"unsigned", false, {{kPaddingValue, 65535, false}}, {65535, 65535, 65535}, 3},
        Padding{"unsigned_pixels_declared_signed",
                false,
                {{kPaddingValue, -2000, true}},
                {65536 - 2000},
                1},
        Padding{"range",
                true,
                {{kPaddingValue, -32000, true}, {kPaddingLimit, -31000, true}},
                {-32000, -31500, -31000, -30999},
                3},
        Padding{"range_downwards",
                true,
                {{kPaddingValue, -31000, true}, {kPaddingLimit, -32000, true}},
                {-32000, -31500, -31000, -30999},
                3}),
    [](const auto& test) { return std::string(test.param.name); });

const Padding kPlain{"plain", true, {{kPaddingValue, -32000, true}}, {-32000}, 1};

TEST(DicomPaddingOf, ANegativeSlopeTurnsTheSmallestRound) {
  auto slices = padded_series(kPlain);
  for (auto& slice : slices) slice.slope = -1;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {0, 0, 0}), -1500 - 1024);
  EXPECT_EQ(volume.value_range, (ValueRange{-1500 - 1024, -10 - 1024}));
}

TEST(DicomPaddingOf, StoredValuesCountWhereEachSliceHasItsOwnRescale) {
  auto slices = padded_series(kPlain);
  slices[0].slope = 0.5;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.value_range, (ValueRange{10 - 1024, 1500 - 1024}));
  EXPECT_EQ(value_at(volume, {0, 0, 0}), 10 - 1024);
}

TEST(DicomPaddingOf, EnhancedFramesShareTheirFilesPadding) {
  TemporaryFolder folder;
  write_enhanced_dicom(folder / "e.dcm", padded_series(kPlain));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.value_range, (ValueRange{10 - 1024, 1500 - 1024}));
}

TEST(DicomPaddingOf, SaysNothingWhereNoPixelIsPadding) {
  auto slices = padded_series(kPlain);
  slices[0].stored[0] = 10;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  EXPECT_TRUE(read_only_volume(folder.path()).description.warnings.empty());
}

TEST(DicomPaddingOf, NothingButPaddingIsRefused) {
  auto slices = padded_series(kPlain);
  for (auto& slice : slices) slice.stored.assign(16, -32000);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  EXPECT_NE(read_failure(only_source(folder.path(), folder.path())).find("is padding"),
            std::string::npos);
}

}  // namespace
}  // namespace cutaway::test
