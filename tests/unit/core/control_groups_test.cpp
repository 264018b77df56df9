// Memory limits of control groups, on trees like those that the kernel shows.
#include "core/control_groups.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace cutaway {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

class ControlGroups : public ::testing::Test {
 protected:
  ControlGroups() { write("proc/self/cgroup", "0::/\n"); }
  ~ControlGroups() override { fs::remove_all(root); }

  void write(const fs::path& file, const std::string& text) {
    fs::create_directories((root / file).parent_path());
    std::ofstream(root / file) << text;
  }
  void limit(const fs::path& file, std::uint64_t bytes) {
    write("sys/fs/cgroup" / file, std::to_string(bytes) + "\n");
  }
  std::optional<std::uint64_t> found() const { return control_group_memory_bytes(root); }

  fs::path root = fs::temp_directory_path() / ("cutaway-groups-" + std::to_string(getpid()));
};

TEST_F(ControlGroups, NoLimitIsNone) {
  EXPECT_EQ(found(), std::nullopt);
  write("sys/fs/cgroup/memory.max", "max\n");
  write("sys/fs/cgroup/memory.high", "max\n");
  EXPECT_EQ(found(), std::nullopt);
  EXPECT_EQ(control_group_memory_bytes(root / "nothing"), std::nullopt);
}

TEST_F(ControlGroups, AContainerHasItsLimitAtTheRoot) {
  limit("memory.max", 512 * kMiB);
  EXPECT_EQ(found(), 512 * kMiB);
}

TEST_F(ControlGroups, AServiceHasItsLimitInItsOwnGroup) {
  write("proc/self/cgroup", "0::/system.slice/cutaway.service\n");
  limit("system.slice/cutaway.service/memory.max", 300 * kMiB);
  EXPECT_EQ(found(), 300 * kMiB);
}

TEST_F(ControlGroups, TheLeastOnTheWayUpCounts) {
  write("proc/self/cgroup", "0::/teaching.slice/course.slice/cutaway.service\n");
  limit("teaching.slice/memory.max", 200 * kMiB);
  write("sys/fs/cgroup/teaching.slice/course.slice/memory.max", "max\n");
  limit("teaching.slice/course.slice/cutaway.service/memory.max", 300 * kMiB);
  limit("other.slice/memory.max", kMiB);
  EXPECT_EQ(found(), 200 * kMiB);
}

TEST_F(ControlGroups, TheLimitAtWhichAGroupIsSlowedCountsAsWell) {
  write("proc/self/cgroup", "0::/a.slice\n");
  limit("a.slice/memory.max", 400 * kMiB);
  limit("a.slice/memory.high", 250 * kMiB);
  EXPECT_EQ(found(), 250 * kMiB);
}

TEST_F(ControlGroups, AGroupThatIsNotToBeSeenFromHereCostsNothing) {
  write("proc/self/cgroup", "0::/../../elsewhere\n");
  limit("memory.max", 512 * kMiB);
  write("elsewhere/memory.max", "1\n");
  EXPECT_EQ(found(), 512 * kMiB);
  write("proc/self/cgroup", "0::/docker/0123\n");
  EXPECT_EQ(found(), 512 * kMiB);
}

TEST_F(ControlGroups, VersionOneSaysWhatHoldsForAllAboveIt) {
  write("proc/self/cgroup", "9:pids:/x\n4:cpu,memory:/a/b\n0::/\n");
  limit("memory/a/memory.limit_in_bytes", 700 * kMiB);
  limit("memory/a/b/memory.limit_in_bytes", 9223372036854771712ULL);
  EXPECT_EQ(found(), 700 * kMiB);
  write("sys/fs/cgroup/memory/a/b/memory.stat",
        "cache 5\nhierarchical_memory_limit " + std::to_string(600 * kMiB) + "\n");
  EXPECT_EQ(found(), 600 * kMiB);
}

TEST_F(ControlGroups, LinesThatAreNoneAreLeftOut) {
  write("proc/self/cgroup", "\nnonsense\n::\n0:a\n4:memoryless:/a\n");
  limit("memory/a/memory.limit_in_bytes", kMiB);
  EXPECT_EQ(found(), std::nullopt);
}

}  // namespace
}  // namespace cutaway
