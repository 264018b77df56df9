#include "import/isolation/isolated_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "core/error.h"
#include "import/decode_memory.h"
#include "unit/import/isolated_test_support.h"
#include "volume/parallel.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

std::string failure(const IsolatedReader& isolation, const VolumeSource& source) {
  try {
    read_volume_isolated(isolation, source, {.volume_bytes = 1 << 20}, {}, {});
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().field, source.files.front().string());
    return std::string(code_word(error.detail().code)) + ": " + error.what();
  }
  return "";
}

TEST(IsolatedReader, GivesTheSameVolumeAsTheReaderItself) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  std::vector<std::pair<LoadStage, double>> heard;
  const auto progress = [&](LoadStage stage, double fraction) {
    heard.emplace_back(stage, fraction);
  };
  const Volume isolated = read_volume_isolated(worker(), source, {}, progress, {});
  const Volume direct = read(source);
  EXPECT_EQ(isolated.voxels, direct.voxels);
  EXPECT_EQ(isolated.geometry, direct.geometry);
  EXPECT_EQ(isolated.value_range, direct.value_range);
  EXPECT_EQ(isolated.value_scale, direct.value_scale);
  EXPECT_EQ(isolated.value_offset, direct.value_offset);
  EXPECT_EQ(isolated.description.id, direct.description.id);
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back(), (std::pair{LoadStage::decode, 1.0}));
}

TEST(IsolatedReader, TellsWhatItSetForNothing) {
  TemporaryFolder folder;
  write_file(folder / "f.mha",
             "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\n"
             "ElementDataFile = LOCAL\n" +
                 bytes_of_numbers<float>({NAN, 1, 2, 3, 4, 5, 6, 7}));
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_EQ(read_volume_isolated(worker(), source, {}, {}, {}).nothing_value, 0.0);
}

TEST(IsolatedReader, PassesFloatsToo) {
  TemporaryFolder folder;
  write_file(folder / "f.mha",
             "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\n"
             "ElementDataFile = LOCAL\n" +
                 bytes_of_numbers<float>({0.5F, 1, 2, 3, 4, 5, 6, 1e6F}));
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_EQ(read_volume_isolated(worker(), source, {}, {}, {}).voxels, read(source).voxels);
}

TEST(IsolatedReader, RefusalsArriveAsTheyWere) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  fs::resize_file(source.files.front(), 1000);
  EXPECT_EQ(failure(worker(), source), "volume-refused: " + read_failure(source));
}

TEST(IsolatedReader, LimitsHoldInTheChild) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  try {
    read_volume_isolated(worker(), source, {.volume_bytes = 100}, {}, {});
    FAIL() << "read beyond the limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.detail().code, ErrorCode::too_large);
  }
}

struct Mishap {
  const char* mode;
  const char* words;
};

class IsolatedMishap : public testing::TestWithParam<Mishap> {};

TEST_P(IsolatedMishap, IsAnErrorInWordsAndNothingElse) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  const std::string mode = GetParam().mode;
  IsolatedReader isolation = worker(mode);
  // With a sanitizer the start alone takes a second.
  if (mode == "spin") isolation.processor_time = std::chrono::seconds(1);
  if (mode == "progress-then-hang" || mode == "answer-then-linger")
    isolation.silence = std::chrono::milliseconds(500);
  isolation.memory_bytes = std::uint64_t{1} << 30;
  const std::string message = failure(isolation, source);
  EXPECT_TRUE(message.starts_with("volume-refused")) << message;
  EXPECT_NE(message.find(GetParam().words), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(Modes, IsolatedMishap,
                         testing::Values(Mishap{"crash", "broke down, as it does at damaged files"},
                                         Mishap{"progress-then-hang", "said nothing for"},
                                         Mishap{"answer-then-linger", "did not end"},
                                         Mishap{"spin", "processor time"},
                                         Mishap{"garbage", "answer is not usable"},
                                         Mishap{"null-range", "answer is not usable"},
                                         Mishap{"huge-grid", "another number of voxels"},
                                         Mishap{"too-few-voxels", "another number of voxels"},
                                         Mishap{"nan-voxels", "no numbers"},
                                         Mishap{"write-without-end", "wrote more than"},
                                         Mishap{"exit-7", "ended without an answer"},
                                         Mishap{"silent-success", "answer is not usable"}),
                         [](const auto& test) {
                           std::string name = test.param.mode;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(IsolatedReader, TooMuchMemoryCostsTheChildOnly) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs an address space without limit";
#endif
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  IsolatedReader isolation = worker("hog");
  isolation.memory_bytes = std::uint64_t{1} << 30;
  EXPECT_NE(failure(isolation, source).find("broke down"), std::string::npos);
}

TEST(IsolatedReader, StoppingKillsTheChild) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  std::stop_source stop;
  // The child hangs after its first report; without the stop only the two minutes of silence would
  // end this.
  const auto progress = [&](LoadStage, double) { stop.request_stop(); };
  EXPECT_THROW(
      read_volume_isolated(worker("progress-then-hang"), source, {}, progress, stop.get_token()),
      Cancelled);
}

TEST(IsolatedReader, StoppingFromAnotherThreadWakesTheWait) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  std::stop_source stop;
  std::atomic<bool> heard = false;
  const auto progress = [&](LoadStage, double) {
    heard = true;
    heard.notify_all();
  };
  const std::jthread stopper([&] {
    heard.wait(false);
    stop.request_stop();
  });
  EXPECT_THROW(
      read_volume_isolated(worker("progress-then-hang"), source, {}, progress, stop.get_token()),
      Cancelled);
}

TEST(IsolatedReader, AMissingExecutableIsSaid) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  const IsolatedReader nobody{.executable = folder / "nobody"};
  EXPECT_NE(failure(nobody, source).find("cannot be started"), std::string::npos);
}

std::size_t open_descriptors() {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

TEST(IsolatedReader, LeavesNoDescriptorsAndNoChildren) {
  TemporaryFolder folder;
  const VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  const std::size_t before = open_descriptors();
  for (const char* mode : {"read-volume-worker", "crash", "garbage"}) {
    try {
      read_volume_isolated(worker(mode), source, {}, {}, {});
    } catch (const Error&) {
    }
  }
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_EQ(access("/proc/self/task", F_OK), 0);
  EXPECT_TRUE(read_file("/proc/self/task/" + std::to_string(getpid()) + "/children").empty());
}

/// What a child may take of address space, in KiB, for such a source.
std::uint64_t granted_kib(const TemporaryFolder& folder, const VolumeSource& source,
                          const ImportLimits& limits) {
  const fs::path script = folder / "limit.sh";
  const fs::path answer = folder / "limit";
  // The limit is set from outside, when the child runs already.
  write_file(script,
             "#!/bin/sh\nfor turn in 1 2 3 4 5 6 7 8 9 10; do\n"
             "  [ \"$(ulimit -v)\" = unlimited ] || break\n  sleep 0.1\ndone\n"
             "ulimit -v > '" +
                 answer.string() + "'\n");
  fs::permissions(script, fs::perms::owner_all);
  EXPECT_THROW(
      read_volume_isolated({.executable = script, .arguments = {}}, source, limits, {}, {}), Error);
  return std::stoull(read_file(answer));
}

/// A volume that is one of many in its file: all of them are decoded at once. But a scan that was
/// taken over cannot open the limit.
TEST(IsolatedReader, GrantsTheMemoryToDecodeAWholeFile) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs an address space without limit";
#endif
  TemporaryFolder folder;
  VolumeSource source = only_source(write_ramp_volume(folder), folder.path());
  const ImportLimits limits{.volume_bytes = 1 << 20};
  const auto decoding_kib = [](std::uint64_t bytes) {
    return reading::decode_memory_bytes(bytes) >> 10;
  };
  const std::uint64_t alone = granted_kib(folder, source, limits) - decoding_kib(0);
  source.decode_bytes = 512 << 10;
  EXPECT_EQ(granted_kib(folder, source, limits), alone + decoding_kib(512 << 10));
  source.decode_bytes = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(granted_kib(folder, source, limits), alone + decoding_kib(1 << 20));
}

TEST(DecodeMemory, ManySmallFilesAreDecodedSideBySideAndLargeOnesAlone) {
  constexpr std::uint64_t kSlice = 512 * 512 * 2;
  constexpr std::uint64_t kLarge = std::uint64_t{1} << 30;
  EXPECT_EQ(reading::decode_threads(kSlice), std::min(default_thread_count(), 8));
  EXPECT_EQ(reading::decode_threads(kLarge), 1);
  EXPECT_EQ(reading::decode_threads(std::numeric_limits<std::uint64_t>::max()), 1);
  EXPECT_GE(reading::decode_memory_bytes(kLarge), 4 * kLarge);
  EXPECT_LT(reading::decode_memory_bytes(kLarge), 5 * kLarge);
  EXPECT_LE(reading::decode_memory_bytes(kSlice), std::uint64_t{2} << 30);
}

}  // namespace
}  // namespace cutaway::test
