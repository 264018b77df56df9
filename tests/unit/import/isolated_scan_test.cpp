// A scan outlives the children that do its work: no file costs the others their place.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "unit/import/dicom_writer.h"
#include "unit/import/isolated_test_support.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

Listing isolated_scan(const TemporaryFolder& folder, const IsolatedReader& isolation = worker()) {
  return scan_volumes_isolated(isolation, folder.path(), folder.path(), {}, {});
}

TEST(IsolatedScan, ListsTheSameAsTheScanItself) {
  TemporaryFolder folder;
  write_ramp_volume(folder);
  write_file(folder / "broken.nii", "x");
  const Listing isolated = isolated_scan(folder);
  const Listing direct = scan(folder.path());
  ASSERT_EQ(isolated.volumes.size(), 1U);
  EXPECT_EQ(isolated.volumes[0].geometry, direct.volumes[0].geometry);
  EXPECT_EQ(isolated.volumes[0].files, direct.volumes[0].files);
  ASSERT_EQ(isolated.refused.size(), 1U);
  EXPECT_EQ(isolated.refused[0].reason, direct.refused[0].reason);
}

TEST(IsolatedScan, AMissingFolderIsAnError) {
  EXPECT_THROW(scan_volumes_isolated(worker(), "/nowhere", "/nowhere", {}, {}), Error);
}

/// A worker that crashes at each file whose name begins with "crash", when it is about to open it.
/// What it reports is also kept in `log`.
IsolatedReader fragile_worker(const fs::path& log) {
  return {.executable = CUTAWAY_TEST_WORKER, .arguments = {"crash-at-names", log.string()}};
}

std::size_t lines_with(const fs::path& log, const std::string& part) {
  const std::string text = read_file(log);
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(IsolatedScan, GoesOnBehindEachFileThatStopsItsReader) {
  constexpr std::size_t kSlices = 20;
  constexpr std::size_t kCrashers = 4;
  TemporaryFolder folder;
  TemporaryFolder logs;
  write_ramp_volume(folder);
  write_series(folder / "series", ramp_series(kSlices, {0, 0, 0}, {0, 0, 2}));
  for (std::size_t i = 0; i < kCrashers; ++i) {
    write_file(folder / fmt::format("series/crash{}.dcm", i), "x");
  }
  const Listing listing = isolated_scan(folder, fragile_worker(logs / "log"));
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_EQ(listing.volumes[1].geometry.size_voxels.z, static_cast<int>(kSlices));
  ASSERT_EQ(listing.refused.size(), kCrashers);
  for (const auto& [path, reason] : listing.refused) {
    EXPECT_TRUE(path.filename().string().starts_with("crash")) << path;
    EXPECT_EQ(reason, "its reader broke down, as it does at damaged files");
  }
  // Once by whoever came first, and once by the child that lists them all; a MetaImage thrice, for
  // the first child had listed it.
  EXPECT_LE(lines_with(logs / "log", "opened"), 2 * kSlices + 3);
}

TEST(IsolatedScan, TooManyCrashesLeaveTheRestAloneAndKeepWhatIsGood) {
  TemporaryFolder folder;
  TemporaryFolder logs;
  write_ramp_volume(folder);
  write_series(folder / "a series", ramp_series(5, {0, 0, 0}, {0, 0, 2}));
  for (int i = 0; i < 5; ++i) write_file(folder / fmt::format("many/crash{}.dcm", i), "x");
  write_series(folder / "z series", ramp_series(3, {0, 0, 0}, {0, 0, 2}));
  IsolatedReader isolation = fragile_worker(logs / "log");
  isolation.failures_of_scan = 3;
  const Listing listing = isolated_scan(folder, isolation);
  ASSERT_EQ(listing.volumes.size(), 2U);
  EXPECT_EQ(listing.volumes[0].description.format, "DICOM");
  EXPECT_EQ(listing.volumes[1].description.format, "MetaImage");
  EXPECT_EQ(listing.refused.size(), 5U + 3U);
  const auto left_alone =
      std::count_if(listing.refused.begin(), listing.refused.end(), [](const RefusedFile& refused) {
        return refused.reason ==
               "not looked at, since too many other files here stopped their reader";
      });
  EXPECT_EQ(left_alone, 2 + 3);
}

/// A picture less would put the others in wrong places.
TEST(IsolatedScan, APictureThatStopsItsReaderCostsItsStack) {
  TemporaryFolder folder;
  TemporaryFolder logs;
  for (const char* name : {"crash1.png", "crash2.png", "fine1.png", "fine2.png"})
    write_file(folder / name, png_bytes({.pixels = std::string(20, 'v')}));
  fs::rename(folder / "crash2.png", folder / "crosh2.png");
  write_file(folder / "volume.json", "{}");
  const Listing listing = isolated_scan(folder, fragile_worker(logs / "log"));
  EXPECT_TRUE(listing.volumes.empty());
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, folder / "crash1.png");
  EXPECT_EQ(
      listing.refused[0].reason,
      "its reader broke down, as it does at damaged files; so the stack of 4 pictures that it "
      "belongs to is not read");
}

IsolatedReader scripted(const TemporaryFolder& folder, const std::string& script) {
  const fs::path file = folder / "worker.sh";
  write_file(file, "#!/bin/sh\n" + script);
  fs::permissions(file, fs::perms::owner_all);
  return {.executable = file, .arguments = {}};
}

/// Also where no other child would meet the file.
TEST(IsolatedScan, ACrashAtOneFileIsRefusedByItsName) {
  TemporaryFolder folder;
  write_ramp_volume(folder);
  const std::string real = CUTAWAY_TEST_WORKER;
  const Listing listing = isolated_scan(
      folder, scripted(folder, "read -r job\ncase \"$job\" in\n*'\"given_up\":[]'*) exec " + real +
                                   " crash-at-file;;\n*) echo \"$job\" | " + real +
                                   " read-volume-worker;;\nesac\n"));
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, "/crasher.nii");
  EXPECT_NE(listing.refused[0].reason.find("broke down"), std::string::npos);
  EXPECT_EQ(listing.volumes.size(), 1U);
}

/// No file is to blame, another run would end the same way, and only series depend on it.
TEST(IsolatedScan, ACrashWhileGroupingCostsTheSeriesOnly) {
  TemporaryFolder folder;
  write_ramp_volume(folder);
  write_series(folder / "series", ramp_series(3, {0, 0, 0}, {0, 0, 2}));
  const fs::path runs = folder / "runs";
  const std::string real = CUTAWAY_TEST_WORKER;
  const Listing listing = isolated_scan(
      folder, scripted(folder, "echo run >> '" + runs.string() +
                                   "'\nread -r job\ncase \"$job\" in\n*dicom_refused*) echo "
                                   "\"$job\" | " +
                                   real + " read-volume-worker;;\n*) exec " + real +
                                   " crash-at-grouping;;\nesac\n"));
  EXPECT_EQ(listing.volumes.size(), 1U);
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, folder / "series");
  EXPECT_EQ(listing.refused[0].reason,
            "its reader broke down, as it does at damaged files, while it sorted DICOM slices into "
            "volumes");
  EXPECT_EQ(read_file(runs), "run\nrun\n");
}

/// A scan has no voxels to hand over.
TEST(IsolatedScan, ItsReaderCannotFillTheMemoryWithVoxels) {
  TemporaryFolder folder;
  write_ramp_volume(folder);
  try {
    isolated_scan(folder, worker("write-without-end"));
    FAIL() << "what it wrote was let be";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("wrote more than"), std::string::npos) << error.what();
  }
}

/// A slice whose header alone is longer than what most tests leave of it.
std::string slice_bytes(const TemporaryFolder& folder) {
  DicomSlice slice;
  slice.size_px = {32, 32};
  slice.fill_with_ramp();
  write_dicom(folder / "whole.dcm", slice);
  return read_file(folder / "whole.dcm");
}

/// As interrupted copies leave them. Here one child looks
/// at them all.
TEST(IsolatedScan, SlicesCutOffAtAnyLengthAreRefusedPlainly) {
  TemporaryFolder whole;
  const std::string bytes = slice_bytes(whole);
  TemporaryFolder folder;
  const auto write_cut = [&](std::size_t length) {
    write_file(folder / fmt::format("cut{:04}.dcm", length), bytes.substr(0, length));
  };
  for (std::size_t length = 1; length <= 500; ++length) write_cut(length);
  write_cut(1200);
  write_ramp_volume(folder);
  IsolatedReader isolation = worker();
  isolation.failures_of_scan = 1;  // one crash, and the rest would be left alone
  const Listing listing = isolated_scan(folder, isolation);
  ASSERT_EQ(listing.volumes.size(), 1U);
  EXPECT_EQ(listing.volumes[0].description.format, "MetaImage");
  ASSERT_EQ(listing.refused.size(), 501U);
  for (const auto& [path, reason] : listing.refused) {
    const bool ends_between_elements = reason.find("has no usable size") != std::string::npos;
    const bool ends_in_pixels = reason.find("shorter than its header says") != std::string::npos;
    EXPECT_TRUE(ends_between_elements || ends_in_pixels ||
                reason.find("cut off") != std::string::npos)
        << path << ": " << reason;
  }
}

TEST(IsolatedScan, ASliceCutOffInItsFileHeaderSaysWhatIsMissing) {
  TemporaryFolder folder;
  const std::string bytes = slice_bytes(folder);
  write_file(folder / "whole.dcm", bytes.substr(0, 150));
  EXPECT_EQ(only_refusal(folder.path()),
            "the DICOM header is cut off; expected at least 152 bytes; got 150 bytes");
}

}  // namespace
}  // namespace cutaway::test
