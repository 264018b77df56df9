// Headers are written here from the format's definition, so that the reader is checked against
// that.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

constexpr glm::ivec3 kGridSize(4, 3, 5);
const glm::dmat3 kSteps(0, 1.5, 0, 0, 0, -2, 2.5, 0, 0);
const glm::dvec3 kOrigin(-10, 20, 35.5);

std::string header(const std::string& data_file, const std::string& rest = "") {
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nTransformMatrix = 0 1 0 0 0 -1 1 0 0\n"
         "Offset = -10 20 35.5\nElementSpacing = 1.5 2 2.5\nDimSize = 4 3 5\nElementType = "
         "MET_SHORT\n" +
         rest + "ElementDataFile = " + data_file + "\n";
}

std::vector<std::int16_t> metaimage_ramp() {
  const auto values = ramp_values(kGridSize, kSteps, kOrigin);
  return {values.begin(), values.end()};
}

std::string ramp_bytes(bool big_endian = false) {
  return bytes_of_numbers(metaimage_ramp(), big_endian);
}

void expect_ramp_of(const std::filesystem::path& path) {
  const Volume volume = read_only_volume(path);
  EXPECT_EQ(volume.geometry.size_voxels, kGridSize);
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(1.5, 2, 2.5));
  EXPECT_EQ(volume.description.format, "MetaImage");
  EXPECT_TRUE(volume.description.warnings.empty());
  expect_ramp(volume, 1.0);
}

TEST(MetaImage, ReadsAttachedDataInBothByteOrders) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", header("LOCAL") + ramp_bytes());
  expect_ramp_of(folder.path());
  write_file(folder / "a.mha",
             header("LOCAL", "BinaryDataByteOrderMSB = True\n") + ramp_bytes(true));
  expect_ramp_of(folder.path());
  write_file(folder / "a.mha", header("LOCAL", "ElementByteOrderMSB = True\n") + ramp_bytes(true));
  expect_ramp_of(folder.path());
}

TEST(MetaImage, ReadsCompressedData) {
  TemporaryFolder folder;
  const std::string data = zlib(ramp_bytes());
  const std::string fields =
      fmt::format("CompressedData = True\nCompressedDataSize = {}\n", data.size());
  write_file(folder / "a.mha", header("LOCAL", fields) + data);
  expect_ramp_of(folder / "a.mha");
  write_file(folder / "b.zraw", data);
  write_file(folder / "b.mhd", header("b.zraw", "CompressedData = True\n"));
  expect_ramp_of(folder / "b.mhd");
}

TEST(MetaImage, ReadsDetachedDataBehindAHeaderOfItsOwn) {
  TemporaryFolder folder;
  write_file(folder / "raw/a.raw", "header!" + ramp_bytes());
  write_file(folder / "a.mhd", header("raw/a.raw", "HeaderSize = 7\n"));
  write_file(folder / "b.mhd", header("raw/a.raw", "HeaderSize = -1\n"));
  expect_ramp_of(folder / "a.mhd");
  expect_ramp_of(folder / "b.mhd");
}

TEST(MetaImage, ReadsSlicesInFilesOfTheirOwn) {
  TemporaryFolder folder;
  std::string list;
  for (int k = 0; k < 5; ++k) {
    const std::string name = fmt::format("s{}.raw", k + 1);
    write_file(folder / name, ramp_bytes().substr(static_cast<std::size_t>(k) * 24, 24));
    list += name + "\n";
  }
  write_file(folder / "list.mhd", header("LIST") + list);
  write_file(folder / "pattern.mhd", header("s%d.raw 1 5 1"));
  expect_ramp_of(folder / "list.mhd");
  expect_ramp_of(folder / "pattern.mhd");
}

TEST(MetaImage, ReadsText) {
  std::string text;
  for (const auto value : metaimage_ramp()) text += std::to_string(value) + " ";
  TemporaryFolder folder;
  std::string bytes = header("LOCAL");
  bytes.replace(bytes.find("BinaryData = True"), 17, "BinaryData = False");
  write_file(folder / "a.mha", bytes + text);
  expect_ramp_of(folder.path());
}

TEST(MetaImage, TakesNumbersWithAPlusSign) {
  std::string bytes = header("LOCAL");
  bytes.replace(bytes.find("-10 20 35.5"), 11, "-10 +20 +35.5");
  TemporaryFolder folder;
  write_file(folder / "a.mha", bytes + ramp_bytes());
  expect_ramp_of(folder.path());
}

/// ITK reads arrays as it reads the type of their elements.
TEST(MetaImage, ReadsArraysLikeTheirElements) {
  std::string bytes = header("LOCAL");
  bytes.replace(bytes.find("MET_SHORT"), 9, "MET_SHORT_ARRAY");
  TemporaryFolder folder;
  write_file(folder / "a.mha", bytes + ramp_bytes());
  expect_ramp_of(folder.path());
  write_file(folder / "a.mha",
             "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementNumberOfChannels = 2\n"
             "ElementType = MET_UCHAR_ARRAY\nElementDataFile = LOCAL\nazbzczdzezfzgzhz");
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.value_range, (ValueRange{'a', 'h'}));
  EXPECT_TRUE(has_warning(volume.description, "each voxel has 2 values; the first is shown"));
}

TEST(MetaImage, TakesModalityRescaleAndUnits) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", header("LOCAL",
                                      "Modality = MET_MOD_CT\nElementToIntensityFunctionSlope = 2\n"
                                      "ElementToIntensityFunctionOffset = -1000\n") +
                                   ramp_bytes());
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.description.modality, "CT");
  EXPECT_EQ(volume.description.units, "HU");
  EXPECT_EQ(value_at(volume, {0, 0, 0}), 2 * metaimage_ramp()[0] - 1000);
}

TEST(MetaImage, WithoutSpacingWarns) {
  TemporaryFolder folder;
  write_file(
      folder / "a.mha",
      "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n12345678");
  EXPECT_TRUE(
      has_warning(only_source(folder.path(), folder.path()).description, "gives no spacing"));
}

TEST(MetaImage, ReducesChannelsAndTimesAndSaysSo) {
  TemporaryFolder folder;
  const std::string two =
      "NDims = 4\nDimSize = 2 2 2 3\nElementSpacing = 1 1 1 1\nElementType = MET_UCHAR\n"
      "ElementDataFile = LOCAL\n";
  write_file(folder / "a.mha", two + "\1\2\3\4\5\6\7\10" + std::string(16, 'z'));
  const Volume times = read_only_volume(folder.path());
  EXPECT_EQ(times.value_range, (ValueRange{1, 8}));
  EXPECT_TRUE(has_warning(times.description, "3 volumes"));
  write_file(folder / "a.mha",
             "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementNumberOfChannels = 3\n"
             "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                 std::string(24, '\x64'));
  EXPECT_TRUE(has_warning(read_only_volume(folder.path()).description, "luminance"));
}

struct Broken {
  const char* name;
  const char* from;
  const char* to;
  const char* reason;
};

class BrokenMetaImage : public testing::TestWithParam<Broken> {};

TEST_P(BrokenMetaImage, IsListedWithItsReason) {
  std::string bytes = header("LOCAL") + ramp_bytes();
  const std::size_t at = bytes.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, std::string(GetParam().from).size(), GetParam().to);
  TemporaryFolder folder;
  write_file(folder / "broken.mha", bytes);
  const std::string reason = only_refusal(folder.path());
  EXPECT_NE(reason.find(GetParam().reason), std::string::npos) << reason;
}

INSTANTIATE_TEST_SUITE_P(
    Headers, BrokenMetaImage,
    testing::Values(
        Broken{"bomb", "DimSize = 4 3 5", "DimSize = 32000 32000 32000", "59.6 TiB"},
        Broken{"truncated", "DimSize = 4 3 5", "DimSize = 4 3 6", "shorter than its header says"},
        Broken{"few_sizes", "DimSize = 4 3 5", "DimSize = 4 3", "DimSize"},
        Broken{"zero_size", "DimSize = 4 3 5", "DimSize = 4 0 5", "empty grid"},
        Broken{"nan_spacing", "= 1.5 2 2.5", "= nan 2 2.5", "ElementSpacing"},
        Broken{"zero_spacing", "= 1.5 2 2.5", "= 1.5 0 2.5", "ElementSpacing"},
        Broken{"negative_spacing", "= 1.5 2 2.5", "= 1.5 2 -2.5", "ElementSpacing"},
        Broken{"few_spacings", "= 1.5 2 2.5", "= 1.5 2", "ElementSpacing"},
        Broken{"nan_offset", "-10 20 35.5", "-10 inf 35.5", "Offset"},
        Broken{"long_axis", "0 1 0 0 0 -1", "0 2 0 0 0 -1", "TransformMatrix"},
        Broken{"skew", "0 1 0 0 0 -1", "0 1 0 0 0.6 -0.8", "right angles"},
        Broken{"type", "MET_SHORT", "MET_STRING", "number type"},
        Broken{"array_type", "MET_SHORT", "MET_STRING_ARRAY", "MET_STRING_ARRAY"},
        Broken{"absolute_path", "= LOCAL", "= /etc/passwd", "outside of the data folder"},
        Broken{"parent_path", "= LOCAL", "= ../../secret.raw", "outside of the data folder"},
        Broken{"absent_data", "= LOCAL", "= nothing.raw", "not there"},
        Broken{"no_field", "ObjectType = Image", "ObjectType Image", "Name = value"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(MetaImage, AHeaderThatNeverEndsIsRefused) {
  TemporaryFolder folder;
  write_file(folder / "a.mha", "NDims = 3\nDimSize = 2 2 2\n");
  EXPECT_NE(only_refusal(folder.path()).find("a field ElementDataFile"), std::string::npos);
}

TEST(MetaImage, BrokenCompressedDataFailWithWords) {
  TemporaryFolder folder;
  const std::string whole = zlib(ramp_bytes());
  write_file(folder / "a.mha",
             header("LOCAL", "CompressedData = True\n") + whole.substr(0, whole.size() / 2));
  EXPECT_NE(read_failure(only_source(folder.path(), folder.path())).find("ends before"),
            std::string::npos);
  std::string spoiled = whole;
  spoiled[spoiled.size() - 1] ^= 1;
  write_file(folder / "a.mha", header("LOCAL", "CompressedData = True\n") + spoiled);
  EXPECT_NE(read_failure(only_source(folder.path(), folder.path())).find("broken"),
            std::string::npos);
}

}  // namespace
}  // namespace cutaway::test
