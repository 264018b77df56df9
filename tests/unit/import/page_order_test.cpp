// What is depth among a TIFF's pages, and what channel or time; in which unit; which way up.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "import/natural_order.h"
#include "unit/import/import_test_support.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

constexpr glm::ivec2 kPageSize{5, 4};

/// Plane p has the value 100 p + i + 10 j at column i and row j.
std::string planes(int count, bool big_endian = false) {
  std::vector<std::uint16_t> values;
  for (int p = 0; p < count; ++p) {
    for (int j = 0; j < kPageSize.y; ++j) {
      for (int i = 0; i < kPageSize.x; ++i)
        values.push_back(static_cast<std::uint16_t>(100 * p + i + 10 * j));
    }
  }
  return bytes_of_numbers(values, big_endian);
}

TiffPicture pages(int count, const std::string& description) {
  const auto all = static_cast<std::uint32_t>(count);
  return {.pixels = planes(count), .description = description, .pages = all, .planes = all};
}

Volume read_tiff(const TiffPicture& picture) {
  TemporaryFolder folder;
  write_file(folder / "stack.tif", tiff_bytes(picture));
  return read_only_volume(folder / "stack.tif");
}

/// The slices are these pages, in this order.
void expect_slices(const Volume& volume, const std::vector<int>& expected) {
  ASSERT_EQ(volume.geometry.size_voxels, glm::ivec3(kPageSize, static_cast<int>(expected.size())));
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_EQ(value_at(volume, {2, 1, static_cast<int>(k)}), 100 * expected[k] + 12) << k;
}

std::string ome(const std::string& pixels, const std::string& content = "") {
  return "<?xml version=\"1.0\"?><!-- a comment --><OME "
         "xmlns=\"http://www.openmicroscopy.org\"><Image "
         "ID=\"Image:0\"><Pixels ID=\"Pixels:0\" " +
         pixels + ">" + content + "</Pixels></Image></OME>";
}

struct DescribedPage {
  const char* name;
  std::string description;
  int pages;
  std::vector<int> slices;
  std::string warning;  ///< part of; empty for no word of channels and times
};

class PagesOfATiff : public testing::TestWithParam<DescribedPage> {};

TEST_P(PagesOfATiff, AreSlicesOfOneChannelAndTime) {
  const Volume volume = read_tiff(pages(GetParam().pages, GetParam().description));
  expect_slices(volume, GetParam().slices);
  const std::string& warning = GetParam().warning;
  const bool speaks = has_warning(volume.description, warning.empty() ? "the file" : warning);
  EXPECT_EQ(speaks, !warning.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Texts, PagesOfATiff,
    testing::Values(
        DescribedPage{"imagej_stack", "ImageJ=1.53t\nimages=4\nslices=4\n", 4, {0, 1, 2, 3}, ""},
        DescribedPage{"imagej_without_slices", "ImageJ=1.53t\nimages=4\n", 4, {0, 1, 2, 3}, ""},
        DescribedPage{"imagej_channels",
                      "ImageJ=1.53t\nimages=6\nchannels=3\nslices=2\nhyperstack=true\n",
                      6,
                      {0, 3},
                      "3 channels; the first is shown"},
        DescribedPage{"imagej_times",
                      "ImageJ=1.53t\nimages=6\nslices=2\nframes=3\n",
                      6,
                      {0, 1},
                      "3 times; the first is shown"},
        DescribedPage{"imagej_all",
                      "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\n",
                      12,
                      {0, 2, 4},
                      "2 channels"},
        DescribedPage{"imagej_implied_slices",
                      "ImageJ=1.53t\nimages=6\nchannels=3\n",
                      6,
                      {0, 3},
                      "3 channels"},
        DescribedPage{
            "imagej_film", "ImageJ=1.53t\nimages=4\nframes=4\n", 4, {0, 1, 2, 3}, "times"},
        DescribedPage{"imagej_of_another_file",
                      "ImageJ=1.53t\nimages=8\nchannels=2\nslices=4\n",
                      4,
                      {0, 1, 2, 3},
                      "speaks of 8 planes"},
        DescribedPage{"ome_zct",
                      ome("DimensionOrder=\"XYZCT\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\""),
                      6,
                      {0, 1, 2},
                      "2 channels"},
        DescribedPage{"ome_czt",
                      ome("SizeZ=\"3\" SizeC=\"2\" SizeT=\"1\" DimensionOrder=\"XYCZT\""),
                      6,
                      {0, 2, 4},
                      "2 channels"},
        DescribedPage{"ome_tzc",
                      ome("DimensionOrder='XYTZC' SizeZ='3' SizeC='1' SizeT='2'"),
                      6,
                      {0, 2, 4},
                      "2 times"},
        DescribedPage{
            "ome_tiff_data",
            ome("DimensionOrder=\"XYZCT\" SizeZ=\"3\" SizeC=\"1\" SizeT=\"1\"",
                "<TiffData FirstZ=\"0\" IFD=\"2\"/><TiffData FirstZ=\"1\" IFD=\"1\"/><TiffData "
                "FirstZ=\"2\" IFD=\"0\"/>"),
            3,
            {2, 1, 0},
            ""},
        DescribedPage{"tifffile_axes",
                      R"({"shape": [3, 2, 4, 5], "axes": "ZCYX"})",
                      6,
                      {0, 2, 4},
                      "2 channels"},
        DescribedPage{"tifffile_times_first",
                      R"({"axes": "TZYX", "shape": [2, 3, 4, 5]})",
                      6,
                      {0, 1, 2},
                      "2 times"},
        DescribedPage{
            "tifffile_shape_alone", R"({"shape": [6, 4, 5]})", 6, {0, 1, 2, 3, 4, 5}, ""}),
    [](const auto& test) { return test.param.name; });

/// As ImageJ writes what is larger than 4 GB.
TEST(PagesOfATiff, FollowTheFirstWhereOnlyThatHasADirectory) {
  for (const bool big_endian : {false, true}) {
    expect_slices(read_tiff({.pixels = planes(4, big_endian),
                             .big_endian = big_endian,
                             .description = "ImageJ=1.53t\nimages=4\nslices=4\n",
                             .pages = 1,
                             .planes = 4}),
                  {0, 1, 2, 3});
  }
}

TEST(PagesOfATiff, ThatAreNotThereAreMissed) {
  TemporaryFolder folder;
  write_file(folder / "stack.tif", tiff_bytes({.pixels = planes(3),
                                               .description = "ImageJ=1.53t\nimages=4\nslices=4\n",
                                               .planes = 3}));
  EXPECT_NE(only_refusal(folder.path()).find("promises planes that are not there"),
            std::string::npos);
}

struct UnitCase {
  std::string unit;
  double millimetres;
};

TEST(UnitOfATiff, IsKnownInItsManySpellings) {
  for (const auto& [unit, mm] : std::vector<UnitCase>{{"nm", 1e-6},
                                                      {"um", 1e-3},
                                                      {"micron", 1e-3},
                                                      {"microns", 1e-3},
                                                      {"\xC2\xB5m", 1e-3},
                                                      {"\xB5m", 1e-3},
                                                      {"\xCE\xBCm", 1e-3},
                                                      {"\\u00B5m", 1e-3},
                                                      {"mm", 1.0},
                                                      {"cm", 10.0},
                                                      {"inch", 25.4},
                                                      {"Angstrom", 1e-7}}) {
    SCOPED_TRACE(unit);
    TiffPicture picture = pages(3, "ImageJ=1.53t\nimages=3\nspacing=40.0\nunit=" + unit + "\n");
    picture.resolution = {2, 4};
    const Volume volume = read_tiff(picture);
    const glm::dvec3 expected = glm::dvec3(0.5, 0.25, 40.0) * mm;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(volume.geometry.spacing_mm[axis] / expected[axis], 1.0, 1e-6);
    EXPECT_TRUE(volume.description.warnings.empty());
  }
}

TEST(UnitOfATiff, ThatIsNotKnownIsNamed) {
  const Volume volume = read_tiff(pages(3, "ImageJ=1.53t\nimages=3\nunit=furlong\n"));
  EXPECT_TRUE(has_warning(volume.description, "\"furlong\" is not known"));
  EXPECT_TRUE(has_warning(volume.description, "1 mm was taken"));
  const Volume pixels = read_tiff(pages(3, "ImageJ=1.53t\nimages=3\nunit=pixel\n"));
  EXPECT_FALSE(has_warning(pixels.description, "not known"));
  EXPECT_TRUE(has_warning(pixels.description, "1 mm was taken"));
}

TEST(UnitOfATiff, OfOmeIsItsOwn) {
  const std::string sizes = "DimensionOrder=\"XYZCT\" SizeZ=\"3\" SizeC=\"1\" SizeT=\"1\" ";
  const Volume microns = read_tiff(
      pages(3, ome(sizes + "PhysicalSizeX=\"0.1\" PhysicalSizeY=\"0.2\" PhysicalSizeZ=\"0.5\"")));
  EXPECT_LT(glm::distance(microns.geometry.spacing_mm, glm::dvec3(1e-4, 2e-4, 5e-4)), 1e-10);
  const Volume named = read_tiff(pages(
      3, ome(sizes +
             "PhysicalSizeX=\"4\" PhysicalSizeXUnit=\"nm\" PhysicalSizeY=\"4\" "
             "PhysicalSizeYUnit=\"nm\" PhysicalSizeZ=\"0.04\" PhysicalSizeZUnit=\"\xC2\xB5m\"")));
  EXPECT_LT(glm::distance(named.geometry.spacing_mm, glm::dvec3(4e-6, 4e-6, 4e-5)), 1e-12);
}

/// Each of the eight: where the pixel that is seen at column 1, row 2 is stored.
TEST(OrientationOfATiff, TurnsThePictureAsItIsToBeSeen) {
  const glm::ivec2 last = kPageSize - 1;
  const auto stored = [last](int orientation, int x, int y) -> glm::ivec2 {
    switch (orientation) {
      case 2:
        return {last.x - x, y};
      case 3:
        return {last.x - x, last.y - y};
      case 4:
        return {x, last.y - y};
      case 5:
        return {y, x};
      case 6:
        return {y, last.y - x};
      case 7:
        return {last.x - y, last.y - x};
      case 8:
        return {last.x - y, x};
      default:
        return {x, y};
    }
  };
  for (int orientation = 1; orientation <= 8; ++orientation) {
    SCOPED_TRACE(orientation);
    TiffPicture picture = pages(2, "ImageJ=1.53t\nimages=2\nunit=mm\nspacing=3\n");
    picture.orientation = static_cast<std::uint16_t>(orientation);
    picture.resolution = {2, 4};
    const Volume volume = read_tiff(picture);
    const bool transposed = orientation > 4;
    EXPECT_EQ(volume.geometry.size_voxels,
              transposed ? glm::ivec3(kPageSize.y, kPageSize.x, 2) : glm::ivec3(kPageSize, 2));
    EXPECT_EQ(volume.geometry.spacing_mm.x, transposed ? 0.25 : 0.5);
    const glm::ivec2 from = stored(orientation, 1, 2);
    EXPECT_EQ(value_at(volume, {1, 2, 1}), 100 + from.x + 10 * from.y);
  }
}

TEST(FilesOfAStack, ThatAreOneAPlaneAndChannelAreAStackAChannel) {
  TemporaryFolder folder;
  for (int z = 0; z < 11; ++z) {
    for (int c = 0; c < 2; ++c) {
      std::string pixels = planes(2 * z + c + 1);
      pixels.erase(0, pixels.size() - planes(1).size());
      write_file(folder / fmt::format("t_z{}_c{}.tif", z, c), tiff_bytes({.pixels = pixels}));
    }
  }
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.volumes.size(), 2U);
  expect_slices(read(listing.volumes[0]), {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20});
  expect_slices(read(listing.volumes[1]), {1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21});
}

using Names = std::vector<std::string>;
using Stacks = std::vector<Names>;

TEST(FilesOfAStack, AreCountedByTheNumberThatIsDepth) {
  using reading::stacks_of_names;
  EXPECT_EQ(stacks_of_names({"t_z0_c0", "t_z0_c1", "t_z1_c0", "t_z1_c1"}),
            (Stacks{{"t_z0_c0", "t_z1_c0"}, {"t_z0_c1", "t_z1_c1"}}));
  EXPECT_EQ(stacks_of_names({"c1_z1", "c1_z2", "c2_z1", "c2_z2"}),
            (Stacks{{"c1_z1", "c1_z2"}, {"c2_z1", "c2_z2"}}));
  EXPECT_EQ(stacks_of_names({"img_001_ch00", "img_001_ch01", "img_002_ch00", "img_002_ch01"}),
            (Stacks{{"img_001_ch00", "img_002_ch00"}, {"img_001_ch01", "img_002_ch01"}}));
  EXPECT_EQ(stacks_of_names({"aZ1T1", "aZ1T2", "aZ2T1", "aZ2T2"}),
            (Stacks{{"aZ1T1", "aZ2T1"}, {"aZ1T2", "aZ2T2"}}));
  EXPECT_EQ(stacks_of_names({"slice1_w1", "slice1_w2", "slice2_w1", "slice2_w2"}),
            (Stacks{{"slice1_w1", "slice2_w1"}, {"slice1_w2", "slice2_w2"}}));
  EXPECT_EQ(stacks_of_names({"img_channel000_z000", "img_channel000_z001", "img_channel001_z000",
                             "img_channel001_z001"}),
            (Stacks{{"img_channel000_z000", "img_channel000_z001"},
                    {"img_channel001_z000", "img_channel001_z001"}}));
}

/// One number that varies counts the slices, whatever it is called.
TEST(FilesOfAStack, AreCountedByTheOnlyNumberThatVaries) {
  using reading::stacks_of_names;
  EXPECT_EQ(stacks_of_names({"t1", "t2", "t10"}), (Stacks{{"t1", "t2", "t10"}}));
  EXPECT_EQ(stacks_of_names({"z7_c1", "z7_c2"}), (Stacks{{"z7_c1", "z7_c2"}}));
}

}  // namespace
}  // namespace cutaway::test
