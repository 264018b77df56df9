#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/import/import_test_support.h"
#include "unit/import/nrrd_writer.h"

namespace cutaway::test::nrrd {
namespace {

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

TEST(Nrrd, SaysThatDirectionsOfLengthOneAloneAreNoSpacing) {
  const auto warns = [](const std::string& space, const std::string& first) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\n" + space +
                                      "\nspace directions: " + first +
                                      " (0,0,1) (0,1,0)\nencoding: raw\n\n12345678");
    const VolumeSource source = only_source(folder.path(), folder.path());
    return has_warning(source.description, "no physical spacing") &&
           has_warning(source.description, "1 mm");
  };
  EXPECT_TRUE(warns("space dimension: 3", "(-1,0,0)"));
  EXPECT_FALSE(warns("space dimension: 3", "(0.7,0,0)"));
  EXPECT_FALSE(warns("space dimension: 3\nspace units: \"mm\" \"mm\" \"mm\"", "(-1,0,0)"));
  EXPECT_FALSE(warns("space: LPS", "(-1,0,0)"));
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

TEST(Nrrd, TakesSpacingsInTheirUnits) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 0.2 0.25 4\n"
             "units: \"cm\" \"cm\" \"\"\nencoding: raw\n\n12345678");
  EXPECT_EQ(only_source(folder.path(), folder.path()).geometry.spacing_mm, glm::dvec3(2, 2.5, 4));
}

/// NaN is NRRD's sign for an axis that is not one of space.
TEST(Nrrd, AnAxisWithoutAPlaceHoldsComponents) {
  for (const char* hint :
       {"spacings: NaN 1 1.5 2\n", "kinds: ??? domain domain domain\nspacings: 1 1 1.5 2\n",
        "kinds: none space space space\nspacings: nan 1 1.5 2\n",
        "centers: ??? cell cell cell\nspacings: 1 1 1.5 2\n",
        "centerings: none cell cell cell\nspacings: 1 1 1.5 2\n",
        "kinds: 3-vector domain domain domain\nspacings: NaN 1 1.5 2\n",
        "space: left-posterior-superior\nspace directions: (nan,nan,nan) (1,0,0) (0,1.5,0) "
        "(0,0,2)\n"}) {
    TemporaryFolder folder;
    write_file(folder / "a.nrrd",
               "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 2 3\nencoding: raw\n" +
                   std::string(hint) + "\n" + "1xx2xx3xx4xx5xx6xx7xx8xx9xx:xx;xx<xx");
    const Volume volume = read_only_volume(folder / "a.nrrd");
    SCOPED_TRACE(hint);
    EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(2, 2, 3));
    EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(1, 1.5, 2));
    EXPECT_EQ(value_at(volume, {1, 1, 2}), '<');
    EXPECT_TRUE(has_warning(volume.description, "each voxel has 3 values; the first is shown"));
  }
}

TEST(Nrrd, NamesTheUnitsOfItsSamples) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 2\nsample units: "
             "BQML\nencoding: raw\n\n12345678");
  EXPECT_EQ(read_only_volume(folder / "a.nrrd").description.units, "BQML");
}

TEST(Nrrd, ALastAxisWithoutAPlaceHoldsTimes) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 2 3\nspacings: 1 1 2 NaN\nencoding: "
             "raw\n\n123456781234567812345678");
  const Volume volume = read_only_volume(folder / "a.nrrd");
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(1, 1, 2));
  EXPECT_TRUE(has_warning(volume.description, "3 volumes"));
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

}  // namespace
}  // namespace cutaway::test::nrrd
