#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/import/import_test_support.h"
#include "unit/import/nrrd_writer.h"

namespace cutaway::test::nrrd {
namespace {

std::string placed(const std::string& directions, const std::string& origin) {
  return "NRRD0004\ntype: uchar\ndimension: 3\nspace: LPS\nsizes: 2 2 2\nspace directions: " +
         directions + "\nspace origin: " + origin + "\nencoding: raw\n\n12345678";
}

/// No camera could be put in front of it.
TEST(Nrrd, AVolumeFarFromThePatientIsRefusedInWords) {
  const std::string unit = "(1,0,0) (0,1,0) (0,0,1)";
  const std::pair<std::string, std::string> places[]{{unit, "(5e6,0,0)"},
                                                     {unit, "(0,-5e6,0)"},
                                                     {unit, "(0,0,1e300)"},
                                                     {unit, "(99999.5,0,0)"},
                                                     {"(1,0,0) (0,1,0) (0,0,-150000)", "(0,0,0)"}};
  for (const auto& [directions, origin] : places) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", placed(directions, origin));
    const std::string reason = only_refusal(folder.path());
    EXPECT_NE(reason.find("too far from the patient's origin"), std::string::npos) << reason;
    EXPECT_NE(reason.find("expected at most 100 m along each axis"), std::string::npos) << reason;
  }
  TemporaryFolder folder;
  write_file(folder / "a.nrrd", placed(unit, "(99999,-100000,0)"));
  EXPECT_EQ(read_failure(only_source(folder.path(), folder.path())), "");
}

/// What a scan lists can be read: one byte less is refused at once.
TEST(Nrrd, AFileThatIsShortByAByteIsNotListed) {
  std::string hex = hex_of(ramp_bytes());
  std::erase(hex, '\n');
  std::string digits = "7";
  for (int i = 1; i < 60; ++i) digits += " 7";
  const std::pair<const char*, std::string> wholes[]{
      {"raw", ramp_bytes()}, {"hex", hex}, {"ascii", digits}};
  for (const auto& [encoding, data] : wholes) {
    const std::string text = header("LPS", {1, 1, 1}, encoding) + "\n";
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", text + data);
    EXPECT_EQ(read_failure(only_source(folder.path(), folder.path())), "") << encoding;
    write_file(folder / "a.nrrd", text + data.substr(0, data.size() - 1));
    EXPECT_NE(only_refusal(folder.path()).find("shorter than its header says"), std::string::npos)
        << encoding;
  }
}

struct Broken {
  const char* name;
  const char* from;
  const char* to;
  const char* reason;
};

class BrokenNrrd : public testing::TestWithParam<Broken> {};

TEST_P(BrokenNrrd, IsListedWithItsReason) {
  std::string bytes = header("LPS", {1, 1, 1}, "raw") + "\n" + ramp_bytes();
  const std::size_t at = bytes.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, std::string(GetParam().from).size(), GetParam().to);
  TemporaryFolder folder;
  write_file(folder / "broken.nrrd", bytes);
  const std::string reason = only_refusal(folder.path());
  EXPECT_NE(reason.find(GetParam().reason), std::string::npos) << reason;
}

INSTANTIATE_TEST_SUITE_P(
    Headers, BrokenNrrd,
    testing::Values(
        Broken{"magic", "NRRD0005", "NARD0005", "NRRD000n"},
        Broken{"bomb", "sizes: 4 3 5", "sizes: 32000 32000 32000", "59.6 TiB"},
        Broken{"overflow", "sizes: 4 3 5", "sizes: 9223372036854775807 9223372036854775807 9",
               "too large"},
        Broken{"short_file", "sizes: 4 3 5", "sizes: 4 3 50", "shorter than its header says"},
        Broken{"negative_size", "sizes: 4 3 5", "sizes: 4 -3 5", "empty grid"},
        Broken{"few_sizes", "sizes: 4 3 5", "sizes: 4 3", "dimension and sizes"},
        Broken{"block_type", "type: short", "type: block", "number type"},
        Broken{"encoding", "encoding: raw", "encoding: zstd", "gzip or bzip2"},
        Broken{"few_units", "key:=a value", "space units: \"mm\"", "space units"},
        Broken{"two_signs", "(-10,20,35.5)", "(-10,+-20,35.5)", "finite"},
        Broken{"no_endian", "endian: little", "content: x", "byte order"},
        Broken{"nan_direction", "(0,1.5,0)", "(0,nan,0)", "finite"},
        Broken{"zero_direction", "(0,1.5,0)", "(0,0,0)", "spacing is not usable"},
        Broken{"not_at_right_angles", "(0,1.5,0)", "(0,1.5,1)", "right angles"},
        Broken{"negative_spacing", "key:=a value", "spacings: 1 -1 1", "got -1"},
        Broken{"zero_spacing", "key:=a value", "spacings: 1 0 1", "above 0"},
        Broken{"no_field", "key:=a value", "what is this", "no field"},
        Broken{"absolute_path", "key:=a value", "data file: /etc/passwd",
               "outside of the data folder"},
        Broken{"parent_path", "key:=a value", "data file: ../../../etc/passwd",
               "outside of the data folder"},
        Broken{"absent_data", "key:=a value", "data file: nothing.raw", "not there"},
        Broken{"string_pattern", "key:=a value", "data file: %s%n 1 2 1", "pattern"},
        Broken{"rising_pattern_falls", "key:=a value", "data file: s%d.raw 2 1 1", "pattern"},
        Broken{"falling_pattern_rises", "key:=a value", "data file: s%d.raw 1 2 -1", "pattern"},
        Broken{"pattern_stands", "key:=a value", "data file: s%d.raw 1 2 0", "pattern"},
        Broken{"endless_pattern", "key:=a value", "data file: s%d.raw 1 2000000000 1", "pattern"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Nrrd, DataBehindALinkThatLeadsOutIsRefused) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(elsewhere / "secret.raw", ramp_bytes());
  std::filesystem::create_symlink(elsewhere / "secret.raw", folder / "inside.raw");
  std::filesystem::create_directory_symlink(elsewhere.path(), folder / "linked");
  for (const char* name : {"inside.raw", "linked/secret.raw"}) {
    write_file(folder / "a.nhdr",
               header("LPS", {1, 1, 1}, "raw", std::string("data file: ") + name + "\n"));
    const Listing listing = scan(folder / "a.nhdr");
    ASSERT_EQ(listing.refused.size(), 1U);
    EXPECT_NE(listing.refused[0].reason.find("outside of the data folder"), std::string::npos);
  }
}

TEST(Nrrd, AHeaderThatChangesAfterTheScanCannotLeadOut) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(folder / "a.raw", ramp_bytes());
  write_file(elsewhere / "secret.raw", ramp_bytes());
  write_file(folder / "a.nhdr", header("LPS", {1, 1, 1}, "raw", "data file: a.raw\n"));
  const VolumeSource source = only_source(folder.path(), folder.path());
  write_file(folder / "a.nhdr", header("LPS", {1, 1, 1}, "raw",
                                       "data file: " + (elsewhere / "secret.raw").string() + "\n"));
  EXPECT_NE(read_failure(source).find("outside of the data folder"), std::string::npos);
}

TEST(Nrrd, BrokenDataFailWithWords) {
  TemporaryFolder folder;
  const std::pair<const char*, std::string> broken[]{
      {"gzip", gzip(ramp_bytes()).substr(0, 40)},
      {"bzip2", bzip2(ramp_bytes()).substr(0, 40)},
      {"bzip2", bzip2(ramp_bytes().substr(0, 50))},
      {"bzip2", "BZh9" + std::string(120, 'x')},
      {"bzip2", gzip(ramp_bytes())},
      {"ascii", "1 2 3 x 5 " + std::string(120, '7')},
      {"ascii", "1 2 3 99999 5 " + text_of_ramp()},
      {"ascii", "1 2 3 4 5 " + std::string(120, ' ')},
      {"hex", std::string(240, 'g')}};
  for (const auto& [encoding, data] : broken) {
    write_file(folder / "a.nrrd", header("LPS", {1, 1, 1}, encoding) + "\n" + data);
    EXPECT_FALSE(read_failure(only_source(folder.path(), folder.path())).empty()) << encoding;
  }
}

}  // namespace
}  // namespace cutaway::test::nrrd
