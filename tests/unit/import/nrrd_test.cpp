// Headers are written here from the format's definition, so that the reader is checked against
// that.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr glm::ivec3 kSize(4, 3, 5);
const glm::dmat3 kSteps(0, 1.5, 0, 0, 0, -2, 2.5, 0,
                        0);  // LPS: i to posterior, j down, k to the left
const glm::dvec3 kOrigin(-10, 20, 35.5);

std::string vector_text(glm::dvec3 v) { return fmt::format("({},{},{})", v.x, v.y, v.z); }

/// A ramp in short, in the given space; `flip` takes LPS to it.
std::string header(const std::string& space, glm::dvec3 flip, const std::string& encoding,
                   const std::string& rest = "") {
  return "NRRD0005\n# by hand\ntype: short\ndimension: 3\nspace: " + space +
         "\nsizes: 4 3 5\nspace directions: " + vector_text(kSteps[0] * flip) + " " +
         vector_text(kSteps[1] * flip) + " " + vector_text(kSteps[2] * flip) +
         "\nspace origin: " + vector_text(kOrigin * flip) +
         "\nkinds: domain domain domain\nendian: little\nencoding: " + encoding + "\n" + rest +
         "key:=a value\n";
}

std::vector<std::int16_t> ramp() {
  const auto values = ramp_values(kSize, kSteps, kOrigin);
  return {values.begin(), values.end()};
}

std::string ramp_bytes(bool big_endian = false) { return bytes_of_numbers(ramp(), big_endian); }

std::string text_of_ramp() {
  std::string text;
  for (const auto value : ramp())
    text += std::to_string(value) + (text.size() % 7 == 0 ? "\n" : " ");
  return text;
}

std::string hex_of(const std::string& bytes) {
  std::string text;
  for (const char c : bytes)
    text +=
        fmt::format("{:02x}{}", static_cast<unsigned char>(c), text.size() % 35 == 0 ? "\n" : "");
  return text;
}

void expect_ramp_of(const std::filesystem::path& path) {
  const Volume volume = read_only_volume(path);
  EXPECT_EQ(volume.geometry.size_voxels, kSize);
  EXPECT_NEAR(volume.geometry.spacing_mm.x, 1.5, 1e-9);
  EXPECT_NEAR(volume.geometry.spacing_mm.y, 2, 1e-9);
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 2.5, 1e-9);
  EXPECT_TRUE(volume.description.warnings.empty());
  expect_ramp(volume, 1.0);
}

TEST(Nrrd, TakesEachPatientSpaceToLps) {
  const std::pair<const char*, glm::dvec3> spaces[]{{"left-posterior-superior", {1, 1, 1}},
                                                    {"LPS", {1, 1, 1}},
                                                    {"right-anterior-superior", {-1, -1, 1}},
                                                    {"RAS", {-1, -1, 1}},
                                                    {"left-anterior-superior", {1, -1, 1}}};
  for (const auto& [name, flip] : spaces) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", header(name, flip, "raw") + "\n" + ramp_bytes());
    expect_ramp_of(folder.path());
  }
}

TEST(Nrrd, ReadsEveryEncoding) {
  const std::pair<const char*, std::string> encodings[]{
      {"raw", ramp_bytes()},
      {"gzip", gzip(ramp_bytes())},
      {"gz", gzip(ramp_bytes())},
      {"bzip2", bzip2(ramp_bytes())},
      {"bz2", bzip2(ramp_bytes().substr(0, 50)) + bzip2(ramp_bytes().substr(50))},
      {"ascii", text_of_ramp()},
      {"txt", text_of_ramp()},
      {"hex", hex_of(ramp_bytes())}};
  for (const auto& [name, data] : encodings) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", header("LPS", {1, 1, 1}, name) + "\n" + data);
    expect_ramp_of(folder.path());
  }
}

TEST(Nrrd, ReadsBigEndianAndCarriageReturns) {
  std::string text = header("LPS", {1, 1, 1}, "raw");
  text.replace(text.find("endian: little"), 14, "endian: big");
  std::string with_returns;
  for (const char c : text) with_returns += c == '\n' ? std::string("\r\n") : std::string(1, c);
  TemporaryFolder folder;
  write_file(folder / "a.nrrd", with_returns + "\r\n" + ramp_bytes(true));
  expect_ramp_of(folder.path());
}

TEST(Nrrd, ReadsDetachedData) {
  const auto detached = [](const std::string& rest, const std::string& encoding = "raw") {
    return header("LPS", {1, 1, 1}, encoding, rest);
  };
  TemporaryFolder folder;
  write_file(folder / "data/a.raw", ramp_bytes());
  write_file(folder / "a.nhdr", detached("data file: data/a.raw\n"));
  expect_ramp_of(folder / "a.nhdr");
  write_file(folder / "data/skipped.raw", "two\nlines\nxyz" + ramp_bytes());
  write_file(folder / "b.nhdr",
             detached("line skip: 2\nbyte skip: 3\ndatafile: data/skipped.raw\n"));
  expect_ramp_of(folder / "b.nhdr");
  write_file(folder / "c.nhdr", detached("byte skip: -1\ndata file: ./data/skipped.raw\n"));
  expect_ramp_of(folder / "c.nhdr");
  write_file(folder / "data/a.raw.gz", gzip("123" + ramp_bytes()));
  write_file(folder / "d.nhdr", detached("byte skip: 3\ndata file: data/a.raw.gz\n", "gzip"));
  expect_ramp_of(folder / "d.nhdr");
}

TEST(Nrrd, ReadsSlicesInFilesOfTheirOwn) {
  TemporaryFolder folder;
  std::string list;
  for (int k = 0; k < 5; ++k) {
    const std::string name = fmt::format("s{:03d}.raw", k + 8);
    write_file(folder / name, ramp_bytes().substr(static_cast<std::size_t>(k) * 24, 24));
    list += name + "\n";
  }
  write_file(folder / "list.nhdr", header("LPS", {1, 1, 1}, "raw") + "data file: LIST\n" + list);
  write_file(folder / "pattern.nhdr",
             header("LPS", {1, 1, 1}, "raw", "data file: s%03d.raw 8 12 1\n"));
  expect_ramp_of(folder / "list.nhdr");
  expect_ramp_of(folder / "pattern.nhdr");
}

TEST(Nrrd, ReadsSlicesWhoseNumbersFall) {
  TemporaryFolder folder;
  for (int k = 0; k < 5; ++k) {
    write_file(folder / fmt::format("s{:03d}.raw", 12 - 2 * k),
               ramp_bytes().substr(static_cast<std::size_t>(k) * 24, 24));
  }
  write_file(folder / "a.nhdr", header("LPS", {1, 1, 1}, "raw", "data file: s%03d.raw 12 4 -2\n"));
  expect_ramp_of(folder / "a.nhdr");
}

TEST(Nrrd, TakesNumbersWithAPlusSign) {
  std::string text = header("LPS", {1, 1, 1}, "ascii");
  text.replace(text.find("(-10,20,35.5)"), 13, "(-10,+20,+35.5)");
  TemporaryFolder folder;
  write_file(folder / "a.nrrd", text + "\n+" + text_of_ramp());
  expect_ramp_of(folder.path());
}

/// The same grid in other units of the space, of which the factors are exact.
TEST(Nrrd, ScalesSpaceUnitsToMillimetres) {
  const std::pair<const char*, double> units[]{
      {"mm", 1}, {"cm", 10}, {"m", 1000}, {"um", 0.001}, {"\xC2\xB5m", 0.001}};
  for (const auto& [unit, millimetres] : units) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd",
               header("RAS", glm::dvec3(-1, -1, 1) / millimetres, "raw",
                      fmt::format("space units: \"{0}\" \"{0}\" \"{0}\"\n", unit)) +
                   "\n" + ramp_bytes());
    expect_ramp_of(folder.path());
  }
}

TEST(Nrrd, AnUnknownSpaceUnitIsSaidOnce) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             header("LPS", {1, 1, 1}, "raw", "space units: \"mm\" \"furlong\" \"furlong\"\n") +
                 "\n" + ramp_bytes());
  const Volume volume = read_only_volume(folder.path());
  ASSERT_EQ(volume.description.warnings.size(), 1U);
  EXPECT_TRUE(has_warning(volume.description, "\"furlong\" is not known; millimetres were taken"));
  expect_ramp(volume, 1.0);
}

TEST(Nrrd, SaysWhatItTakesTheDirectionsFor) {
  const std::pair<std::string, const char*> spaces[]{
      {"space dimension: 3", "places its voxels in a space without a name"},
      {"space: scanner-xyz", "places its voxels in the space \"scanner-xyz\""}};
  for (const auto& [field, words] : spaces) {
    std::string text = header("LPS", {1, 1, 1}, "raw");
    text.replace(text.find("space: LPS"), 10, field);
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", text + "\n" + ramp_bytes());
    const Volume volume = read_only_volume(folder.path());
    EXPECT_TRUE(has_warning(volume.description, words));
    EXPECT_TRUE(has_warning(volume.description, "taken for the patient's left-posterior-superior"));
    expect_ramp(volume, 1.0);
  }
}

TEST(Nrrd, SaysThatASpaceWithoutDirectionsGivesTheAxes) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 3\nspace: RAS\nsizes: 2 2 2\nspacings: 2 3 4\n"
             "encoding: raw\n\n12345678");
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_TRUE(has_warning(source.description, "i, j, k taken along the axes of its space, RAS"));
  EXPECT_EQ(source.geometry.direction_patient, glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1));
  EXPECT_EQ(source.geometry.spacing_mm, glm::dvec3(2, 3, 4));
}

TEST(Nrrd, WithoutSpaceWarnsOfIt) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678");
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "no physical geometry"));
  EXPECT_TRUE(has_warning(volume.description, "spacing as 1 mm"));
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(1.0));
  EXPECT_EQ(value_at(volume, {1, 1, 1}), '8');
}

TEST(Nrrd, TakesSpacingsWithoutSpace) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 2 NaN 4\nencoding: "
             "raw\n\n12345678");
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_EQ(source.geometry.spacing_mm, glm::dvec3(2, 1, 4));
  EXPECT_TRUE(has_warning(source.description, "no physical geometry"));
}

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

TEST(Nrrd, TakesSpacingsInTheirUnits) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 0.2 0.25 4\n"
             "units: \"cm\" \"cm\" \"\"\nencoding: raw\n\n12345678");
  EXPECT_EQ(only_source(folder.path(), folder.path()).geometry.spacing_mm, glm::dvec3(2, 2.5, 4));
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

TEST(Nrrd, ReducesChannelsAndTimesAndSaysSo) {
  TemporaryFolder folder;
  std::string pixels;
  for (int i = 0; i < 8; ++i) pixels += std::string{static_cast<char>(i), 99, 99};
  write_file(folder / "vector.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 3 2 2 2\nspace directions: "
             "none (1,0,0) (0,1,0) (0,0,1)\n"
             "kinds: vector domain domain domain\nencoding: raw\n\n" +
                 pixels);
  const Volume vector = read_only_volume(folder / "vector.nrrd");
  EXPECT_EQ(vector.value_range, (ValueRange{0, 7}));
  EXPECT_TRUE(has_warning(vector.description, "each voxel has 3 values"));
  write_file(folder / "times.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 2 2 2 2\nspace directions: "
             "(1,0,0) (0,1,0) (0,0,1) none\n"
             "kinds: domain domain domain time\nencoding: raw\n\n\1\2\3\4\5\6\7\10zzzzzzzz");
  const Volume times = read_only_volume(folder / "times.nrrd");
  EXPECT_EQ(times.value_range, (ValueRange{1, 8}));
  EXPECT_TRUE(has_warning(times.description, "2 volumes"));
  write_file(folder / "colour.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\nkinds: RGB-color domain domain "
             "domain\nencoding: raw\n\n" +
                 std::string(24, '\x64'));
  const Volume colour = read_only_volume(folder / "colour.nrrd");
  EXPECT_EQ(value_at(colour, {0, 0, 0}), 100);
  EXPECT_TRUE(has_warning(colour.description, "luminance"));
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
}  // namespace cutaway::test
