// How text headers are taken out of their files, whatever stands before and after.
#include "import/text_header.h"

#include <gtest/gtest.h>

#include <fstream>

#include "unit/import/import_test_support.h"
#include "unit/import/nrrd_writer.h"

namespace cutaway::test::nrrd {
namespace {

/// What this process has read from files so far; nothing where the kernel does not count it.
std::optional<std::uint64_t> bytes_read() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  std::uint64_t count = 0;
  if (counts >> name >> count && name == "rchar:") return count;
  return std::nullopt;
}

std::string comment(std::size_t bytes) { return "#" + std::string(bytes, 'x') + "\n"; }

/// Ends of lines come to lie on every side of the pieces in which a file is read.
TEST(TextHeader, IsReadWholeAcrossPieces) {
  std::string comments;
  for (std::size_t length = 0; length < 600; ++length) comments += comment(length);
  comments += comment(60000);
  TemporaryFolder folder;
  write_file(folder / "a.nrrd", header("LPS", {1, 1, 1}, "raw") + comments + "\n" + ramp_bytes());
  expect_ramp(read_only_volume(folder.path()), 1.0);
}

TEST(TextHeader, EndsAtTheLineThatNoHeaderHas) {
  TemporaryFolder folder;
  const auto file = folder / "a.txt";
  write_file(file, "one\r\n" + std::string(64 << 10, 'x') + "\ntwo\n" +
                       std::string((64 << 10) + 1, 'x') + "\nthree\n");
  reading::HeaderLines lines(file);
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.position(), 5U);
  EXPECT_EQ(lines.next(), std::string(64 << 10, 'x'));
  EXPECT_EQ(lines.next(), "two");
  EXPECT_EQ(lines.position(), 5U + (64 << 10) + 1 + 4);
  EXPECT_EQ(lines.next(), std::nullopt);
}

TEST(TextHeader, EndsAfterFourMebibytes) {
  TemporaryFolder folder;
  constexpr std::size_t kMost = std::size_t{4} << 20;
  std::string text;
  while (text.size() <= kMost) text += "a line\n";
  write_file(folder / "a.txt", text);
  reading::HeaderLines lines(folder / "a.txt");
  std::size_t count = 0;
  while (lines.next()) ++count;
  EXPECT_EQ(lines.position(), kMost);
  EXPECT_EQ(count, (kMost + 6) / 7);
}

TEST(TextHeader, ALastLineNeedsNoEnd) {
  TemporaryFolder folder;
  write_file(folder / "a.txt", "one\n\nlast");
  reading::HeaderLines lines(folder / "a.txt");
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.next(), "");
  EXPECT_EQ(lines.next(), "last");
  EXPECT_EQ(lines.position(), 9U);
  EXPECT_EQ(lines.next(), std::nullopt);
}

/// A scan looks into every file: what follows the header is not its business.
TEST(TextHeader, DoesNotReadTheVoxelsBehindIt) {
  TemporaryFolder folder;
  const auto file = folder / "a.txt";
  write_file(file, "one\n" + std::string(std::size_t{8} << 20, 'x'));
  const auto before = bytes_read();
  if (!before) GTEST_SKIP() << "this kernel does not count what is read";
  EXPECT_EQ(reading::HeaderLines(file).next(), "one");
  EXPECT_LT(*bytes_read() - *before, std::uint64_t{100} << 10);
}

}  // namespace
}  // namespace cutaway::test::nrrd
