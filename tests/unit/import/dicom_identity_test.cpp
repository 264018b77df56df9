// Which slices belong together: by whom, by what, and by when they were taken.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr DicomTag kPatient{0x0010, 0x0020};
constexpr DicomTag kStudy{0x0020, 0x000d};
constexpr DicomTag kSeriesNumber{0x0020, 0x0011};
constexpr DicomTag kFrameOfReference{0x0020, 0x0052};
constexpr DicomTag kKernel{0x0018, 0x1210};
constexpr DicomTag kThickness{0x0018, 0x0050};
constexpr DicomTag kNumberInSeries{0x0020, 0x0013};
constexpr DicomTag kAcquisitionTime{0x0008, 0x0032};

std::vector<int> depths_of(const Listing& listing) {
  std::vector<int> depths;
  for (const auto& source : listing.volumes) depths.push_back(source.geometry.size_voxels.z);
  std::sort(depths.begin(), depths.end());
  return depths;
}

struct Belonging {
  const char* name;
  DicomTag tag;
  const char* first;
  const char* second;
};

class DicomIdentity : public testing::TestWithParam<Belonging> {};

/// One above the other under one SeriesInstanceUID, as damaged identifiers leave them.
TEST_P(DicomIdentity, StacksOfDifferentOwnersAreTwoVolumes) {
  TemporaryFolder folder;
  write_series(folder.path(),
               with_text(ramp_series(5, {0, 0, 0}, {0, 0, 2}), GetParam().tag, GetParam().first),
               "a");
  write_series(folder.path(),
               with_text(ramp_series(6, {0, 0, 10}, {0, 0, 2}), GetParam().tag, GetParam().second),
               "b");
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.refused.empty());
  EXPECT_EQ(depths_of(listing), (std::vector{5, 6}));
  for (const auto& source : listing.volumes) {
    expect_ramp(read(source), 0.6);
    const std::string shown = source.description.title + source.description.id;
    EXPECT_EQ(shown.find("Miller"), std::string::npos) << shown;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Owners, DicomIdentity,
    testing::Values(Belonging{"patient", kPatient, "1-Miller", "2-Miller"},
                    Belonging{"name", {0x0010, 0x0010}, "Miller^A", "Miller^B"},
                    Belonging{"study", kStudy, "1.2.3", "1.2.4"},
                    Belonging{"series_number", kSeriesNumber, "2", "3"},
                    Belonging{"frame_of_reference", kFrameOfReference, "1.5", "1.6"},
                    Belonging{"kernel", kKernel, "B30f", "B70f"}),
    [](const auto& test) { return std::string(test.param.name); });

/// Made anew for each file where names were taken out.
TEST(DicomIdentities, ThatDifferAtEachSliceTellNothing) {
  for (const DicomTag& tag : {kStudy, kFrameOfReference, DicomTag{0x0020, 0x000e}}) {
    auto slices = with_text(ramp_series(6, {0, 0, 0}, {0, 0, 2}), kSeriesNumber, "4");
    for (std::size_t k = 0; k < slices.size(); ++k)
      slices[k].texts[tag] = "1.2." + std::to_string(k);
    TemporaryFolder folder;
    write_series(folder.path(), slices);
    const Volume volume = read_only_volume(folder.path());
    EXPECT_EQ(volume.geometry.size_voxels.z, 6);
    EXPECT_EQ(has_warning(volume.description, "each slice names another"),
              tag != kFrameOfReference);
  }
}

TEST(DicomIdentities, ThatAreMissingOrWrittenInAnotherWayDoNotPartSlices) {
  auto slices = with_text(ramp_series(6, {0, 0, 0}, {0, 0, 2}), kFrameOfReference, "1.5");
  slices[2].texts[kFrameOfReference] = "";
  slices[4].texts[kPatient] = "";
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].texts[kSeriesNumber] = k % 2 == 0 ? "7" : "07";
    slices[k].texts[{0x0010, 0x0010}] = k % 2 == 0 ? "Miller^Ann^^" : "MILLER^ANN";
  }
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  EXPECT_EQ(read_only_volume(folder.path()).geometry.size_voxels.z, 6);
}

TEST(DicomIdentities, SeriesWithoutAnIdentifierAreToldApartByTheirFolders) {
  const auto slices = with_text(ramp_series(4, {0, 0, 0}, {0, 0, 2}), {0x0020, 0x000e}, "");
  TemporaryFolder folder;
  write_series(folder / "a", slices);
  write_series(folder / "b", slices);
  EXPECT_EQ(depths_of(scan(folder.path())), (std::vector{4, 4}));
}

TEST(DicomIdentities, ALocalizerBesideItsSeriesIsNamedAndNoPartOfIt) {
  TemporaryFolder folder;
  auto slices = ramp_series(5, {0, 0, 0}, {0, 0, 2});
  slices.push_back(slices.front());
  slices.back().position_mm = {0, 0, 100};
  slices.back().texts[{0x0008, 0x0008}] = "ORIGINAL\\PRIMARY\\LOCALIZER";
  write_series(folder.path(), slices);
  const Listing listing = scan(folder.path());
  EXPECT_EQ(depths_of(listing), (std::vector{5}));
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_NE(listing.refused[0].reason.find("localizer"), std::string::npos);
}

std::vector<DicomSlice> stack_of_thickness(const char* mm, int count, double first, double step) {
  return with_text(ramp_series(count, {0, 0, first}, {0, 0, step}), kThickness, mm);
}

TEST(DicomThickness, ThinAndThickBetweenEachOtherAreTwoVolumes) {
  for (const double offset : {1.0, 0.0, 2.0}) {  // between, on top of, and evenly between
    TemporaryFolder folder;
    write_series(folder.path(), stack_of_thickness("1.5", 10, 0, 2), "a");
    write_series(folder.path(), stack_of_thickness("5.0", 5, offset, 4), "b");
    const Listing listing = scan(folder.path());
    EXPECT_TRUE(listing.refused.empty());
    ASSERT_EQ(depths_of(listing), (std::vector{5, 10}));
    for (const auto& source : listing.volumes) {
      EXPECT_TRUE(source.description.warnings.empty());
      expect_ramp(read(source), 0.6);
    }
  }
}

/// The base of the skull is often taken in finer steps.
TEST(DicomThickness, OneBehindTheOtherIsOneVolumeWhoseSpacingChanges) {
  TemporaryFolder folder;
  write_series(folder.path(), stack_of_thickness("4", 13, 0, 4), "a");
  write_series(folder.path(), stack_of_thickness("7", 12, 55, 7), "b");
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "changes from 4 to 7 mm"));
  EXPECT_FALSE(has_warning(volume.description, "missing"));
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 4, 1e-9);
}

/// `moments` of `count` slices; `describe` gives each its times and number.
template <typename Describe>
std::vector<DicomSlice> perfusion(int moments, int count, const Describe& describe) {
  std::vector<DicomSlice> slices;
  for (int t = 0; t < moments; ++t) {
    for (int k = 0; k < count; ++k) {
      DicomSlice& slice = slices.emplace_back();
      slice.position_mm = {0, 0, 2.0 * k};
      slice.stored.assign(16, static_cast<std::int16_t>(100 * (t + 1) + k));
      describe(slice, t, k);
    }
  }
  return slices;
}

const VolumeSource& titled(const Listing& listing, const std::string& words) {
  return *std::find_if(listing.volumes.begin(), listing.volumes.end() - 1, [&](const auto& source) {
    return source.description.title.find(words) != words.npos;
  });
}

void expect_moments(const std::vector<DicomSlice>& slices, int moments, int count) {
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.refused.empty()) << listing.refused.front().reason;
  ASSERT_EQ(listing.volumes.size(), static_cast<std::size_t>(moments));
  for (int t = 0; t < moments; ++t) {
    const auto& source = titled(listing, "(time " + std::to_string(t + 1) + ")");
    const Volume volume = read(source);
    ASSERT_EQ(volume.geometry.size_voxels.z, count);
    for (int k = 0; k < count; ++k)
      EXPECT_EQ(value_at(volume, {1, 1, k}), 100 * (t + 1) + k) << t << ", " << k;
  }
}

TEST(DicomMoments, TimesThatDifferAtEachSliceRunOn) {
  expect_moments(perfusion(12, 4,
                           [](DicomSlice& slice, int t, int k) {
                             slice.texts[kAcquisitionTime] =
                                 std::to_string(100000 + t) + ".0" + std::to_string(k);
                             slice.texts[kNumberInSeries] = std::to_string(t * 4 + k + 1);
                           }),
                 12, 4);
}

TEST(DicomMoments, ATableThatGoesToAndFroIsFollowed) {
  expect_moments(perfusion(3, 5,
                           [](DicomSlice& slice, int t, int k) {
                             const int step = t % 2 == 0 ? k : 4 - k;
                             slice.texts[kAcquisitionTime] =
                                 std::to_string(235950 + t) + "." + std::to_string(step);
                           }),
                 3, 5);
}

TEST(DicomMoments, InstanceNumbersAloneTellThem) {
  expect_moments(perfusion(3, 5,
                           [](DicomSlice& slice, int t, int k) {
                             slice.texts[kNumberInSeries] = std::to_string(t * 5 + k + 1);
                           }),
                 3, 5);
}

TEST(DicomMoments, AScannerThatStaysAtAPlaceForAllOfThemIsFollowed) {
  expect_moments(perfusion(3, 5,
                           [](DicomSlice& slice, int t, int k) {
                             slice.texts[kNumberInSeries] = std::to_string(k * 3 + t + 1);
                           }),
                 3, 5);
}

TEST(DicomMoments, ASliceThatIsMissingMovesNoneToAnotherTime) {
  auto slices = perfusion(3, 6, [](DicomSlice& slice, int t, int k) {
    slice.texts[kNumberInSeries] = std::to_string(t * 6 + k + 1);
  });
  slices.erase(slices.begin() + 2);
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 3U);
  EXPECT_TRUE(has_warning(listing.volumes[0].description, "1 slice is missing"));
  EXPECT_EQ(value_at(read(listing.volumes[0]), {0, 0, 3}), 103);
  EXPECT_EQ(value_at(read(listing.volumes[1]), {0, 0, 2}), 202);
}

/// Empty at both times, but no copies: each time needs its own.
TEST(DicomMoments, SlicesThatLookAlikeStayWithTheirTimes) {
  auto slices = perfusion(2, 5, [](DicomSlice& slice, int t, int k) {
    slice.texts[kAcquisitionTime] = std::to_string(100000 + t);
    if (k == 0) slice.stored.assign(16, 0);
  });
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  EXPECT_EQ(depths_of(scan(folder.path())), (std::vector{5, 5}));
}

}  // namespace
}  // namespace cutaway::test
