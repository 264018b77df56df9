#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "import/natural_order.h"
#include "unit/import/import_test_support.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 kSize(5, 4);

template <typename T>
std::vector<T> page(int slice) {
  std::vector<T> pixels(static_cast<std::size_t>(kSize.x * kSize.y));
  std::iota(pixels.begin(), pixels.end(), static_cast<T>(slice * 20));
  return pixels;
}

template <typename T>
OIIO::ImageSpec spec_of(int channels) {
  return {kSize.x, kSize.y, channels, OIIO::BaseTypeFromC<T>::value};
}

template <typename T>
void write_picture(const fs::path& file, const OIIO::ImageSpec& spec,
                   const std::vector<T>& pixels) {
  fs::create_directories(file.parent_path());
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<T>::value, pixels.data()));
  ASSERT_TRUE(output->close());
}

template <typename T>
void write_stack(const fs::path& folder, const char* pattern, int slices,
                 const OIIO::ImageSpec& spec) {
  for (int k = 0; k < slices; ++k) {
    write_picture(folder / fmt::format(fmt::runtime(pattern), k + 1), spec, page<T>(k));
  }
}

void expect_pages(const Volume& volume, int slices) {
  ASSERT_EQ(volume.geometry.size_voxels, glm::ivec3(kSize, slices));
  for (int k = 0; k < slices; ++k) {
    for (int j = 0; j < kSize.y; ++j) {
      for (int i = 0; i < kSize.x; ++i) {
        ASSERT_EQ(value_at(volume, {i, j, k}), k * 20 + j * kSize.x + i)
            << i << " " << j << " " << k;
      }
    }
  }
}

TEST(ImageStack, ReadsEightAndSixteenBitsOfBothFormatsInNaturalOrder) {
  for (const char* pattern : {"slice{}.tif", "slice{}.png", "Slice {:04d} of 12.tiff"}) {
    TemporaryFolder folder;
    write_stack<std::uint8_t>(folder / "eight", pattern, 12, spec_of<std::uint8_t>(1));
    write_stack<std::uint16_t>(folder / "sixteen", pattern, 12, spec_of<std::uint16_t>(1));
    for (const char* name : {"eight", "sixteen"}) {
      const Volume volume = read_only_volume(folder / name);
      expect_pages(volume, 12);
      EXPECT_EQ(volume.description.id, name);
      EXPECT_EQ(volume.description.format, "image stack");
      EXPECT_TRUE(has_warning(volume.description, "1 mm was taken"));
    }
  }
}

void write_tiffs(const fs::path& folder, TiffPicture picture) {
  for (int k = 0; k < 3; ++k) {
    picture.pixels = bytes_of_numbers(page<std::uint16_t>(k), picture.big_endian);
    write_file(folder / fmt::format("s{}.tif", k), tiff_bytes(picture));
  }
}

TEST(ImageStack, ReadsTiffInBothByteOrders) {
  for (const bool big : {false, true}) {
    TemporaryFolder folder;
    write_tiffs(folder.path(), {.big_endian = big});
    expect_pages(read_only_volume(folder.path()), 3);
  }
}

TEST(ImageStack, ReadsFloats) {
  TemporaryFolder folder;
  write_stack<float>(folder.path(), "s{}.tif", 3, spec_of<float>(1));
  expect_pages(read_only_volume(folder.path()), 3);
}

TEST(ImageStack, ReadsThePagesOfOneTiff) {
  TemporaryFolder folder;
  const fs::path file = folder / "pages.tif";
  const std::vector<OIIO::ImageSpec> specs(6, spec_of<std::uint16_t>(1));
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output->open(file.string(), 6, specs.data()));
  for (int k = 0; k < 6; ++k) {
    ASSERT_TRUE(k == 0 || output->open(file.string(), specs[0], OIIO::ImageOutput::AppendSubimage));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT16, page<std::uint16_t>(k).data()));
  }
  ASSERT_TRUE(output->close());
  const Volume volume = read_only_volume(folder.path());
  expect_pages(volume, 6);
  EXPECT_EQ(volume.description.id, "pages.tif");
}

TEST(ImageStack, TakesSpacingFromTheResolution) {
  TemporaryFolder folder;
  write_tiffs(folder / "cm", {.resolution = {20, 25}, .resolution_unit = 3});
  write_tiffs(folder / "inch",
              {.big_endian = true, .resolution = {254, 127}, .resolution_unit = 2});
  const VolumeSource cm = only_source(folder / "cm", folder.path());
  EXPECT_NEAR(cm.geometry.spacing_mm.x, 0.5, 1e-6);
  EXPECT_NEAR(cm.geometry.spacing_mm.y, 0.4, 1e-6);
  EXPECT_TRUE(has_warning(cm.description, "no distance between slices"));
  EXPECT_NEAR(only_source(folder / "inch", folder.path()).geometry.spacing_mm.y, 0.2, 1e-6);
}

TEST(ImageStack, TakesSpacingFromImageJsDescription) {
  TemporaryFolder folder;
  write_tiffs(folder.path(),
              {.resolution = {2, 4}, .description = "ImageJ=1.53\nunit=mm\nspacing=2.5\n"});
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_EQ(source.geometry.spacing_mm, glm::dvec3(0.5, 0.25, 2.5));
  EXPECT_TRUE(source.description.warnings.empty());
}

TEST(ImageStack, TakesSpacingFromAPngsResolution) {
  TemporaryFolder folder;
  OIIO::ImageSpec spec = spec_of<std::uint8_t>(1);
  spec.attribute("XResolution", 2000.0F);
  spec.attribute("YResolution", 2000.0F);
  spec.attribute("ResolutionUnit", "m");
  write_stack<std::uint8_t>(folder.path(), "s{}.png", 3, spec);
  EXPECT_NEAR(only_source(folder.path(), folder.path()).geometry.spacing_mm.x, 0.5, 1e-6);
}

constexpr const char* kSidecar =
    R"({"title": "A head", "modality": "CT", "spacing_mm": [1, 2, 3], "origin_lps_mm": [4, 5, 6],
  "direction_lps": [1, 0, 0, 0, 0, 1, 0, 1, 0], "rescale": {"slope": 2, "intercept": -1024}, "units": "HU"})";

TEST(ImageStack, BelievesItsSidecarAlsoOnALeftHandedGrid) {
  TemporaryFolder folder;
  write_stack<std::uint16_t>(folder.path(), "s{}.tif", 3, spec_of<std::uint16_t>(1));
  write_file(folder / "volume.json", kSidecar);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.description.title, "A head");
  EXPECT_EQ(volume.description.units, "HU");
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(1, 2, 3));
  EXPECT_EQ(volume.geometry.origin_patient_mm, glm::dvec3(4, 5, 6));
  EXPECT_EQ(volume.geometry.direction_patient, glm::dmat3(1, 0, 0, 0, 0, 1, 0, 1, 0));
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 2 * 1 - 1024);
  EXPECT_TRUE(volume.description.warnings.empty());
}

TEST(ImageStack, ABrokenSidecarIsNamed) {
  const std::pair<std::string, const char*> broken[]{
      {"{", "JSON object"},
      {R"({"spacing_mm": [1, 2]})", "spacing_mm"},
      {R"({"spacing_mm": [1, 0, 2]})", "spacing_mm"},
      {R"({"spacing_mm": [1, -1, 2]})", "spacing_mm"},
      {R"({"direction_lps": [2, 0, 0, 0, 1, 0, 0, 0, 1]})", "direction_lps"},
      {R"({"direction_lps": [1, 1, 0, 0, 0, 0, 0, 0, 1]})", "right angles"},
      {R"({"rescale": {"slope": 0}})", "slope"},
      {R"({"units": "miles"})", "units"},
      {R"({"title": 7})", "title"}};
  for (const auto& [text, reason] : broken) {
    TemporaryFolder folder;
    write_stack<std::uint8_t>(folder.path(), "s{}.tif", 2, spec_of<std::uint8_t>(1));
    write_file(folder / "volume.json", text);
    const std::string refusal = only_refusal(folder.path());
    EXPECT_NE(refusal.find(reason), std::string::npos) << text << ": " << refusal;
  }
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// However long, and however deep, what the file says is.
TEST(ImageStack, ASidecarsRefusalIsShort) {
  const std::string deep = repeated("[", 30000) + repeated("]", 30000);
  const std::pair<std::string, const char*> broken[]{
      {R"({"spacing_mm": [)" + repeated("1,", 30000) + "1]}", "spacing_mm"},
      {R"({"units": ")" + repeated("\u00e9", 10000) + "\"}", "units"},
      {R"({"spacing_mm": )" + deep + "}", "nested too deeply"},
      {R"({"unknown": )" + deep + "}", "nested too deeply"},
      {deep, "nested too deeply"}};
  for (const auto& [text, reason] : broken) {
    TemporaryFolder folder;
    write_stack<std::uint8_t>(folder.path(), "s{}.tif", 2, spec_of<std::uint8_t>(1));
    write_file(folder / "volume.json", text);
    const std::string refusal = only_refusal(folder.path());
    EXPECT_NE(refusal.find(reason), std::string::npos) << refusal;
    EXPECT_LT(refusal.size(), 300U) << refusal;
  }
}

TEST(ImageStack, WhatASidecarSaysTooMuchIsShortToo) {
  TemporaryFolder folder;
  write_stack<std::uint8_t>(folder.path(), "s{}.tif", 2, spec_of<std::uint8_t>(1));
  std::string fields = "\"" + repeated("name", 5000) + "\": 1";
  for (int i = 0; i < 1000; ++i) fields += fmt::format(", \"unknown{}\": 1", i);
  write_file(folder / "volume.json", R"({"spacing_mm": [1, 1, 1], "title": ")" +
                                         repeated("x", 9000) + "\", " + fields + "}");
  const VolumeDescription description = only_source(folder.path(), folder.path()).description;
  EXPECT_LT(description.title.size(), 110U);
  EXPECT_EQ(description.warnings.size(), 9U);
  EXPECT_TRUE(has_warning(description, "so were 993 more fields"));
  for (const auto& warning : description.warnings) EXPECT_LT(warning.size(), 200U);
}

TEST(ImageStack, ReducesColourAndSaysSo) {
  TemporaryFolder folder;
  for (int k = 0; k < 2; ++k) {
    write_picture(folder / fmt::format("s{}.png", k), spec_of<std::uint8_t>(3),
                  std::vector<std::uint8_t>(60, 100));
  }
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {0, 0, 0}), 100);
  EXPECT_TRUE(has_warning(volume.description, "luminance"));
}

/// Grey 100 at half opacity is 100, and what alpha hides is there.
TEST(ImageStack, AlphaDoesNotChangeTheValues) {
  const std::pair<int, const char*> kinds[]{{2, "the second channel (alpha) was left out"},
                                            {4, "the fourth channel (alpha) was left out"}};
  for (const auto& [channels, warning] : kinds) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < kSize.x * kSize.y; ++i) {
      pixels.insert(pixels.end(), static_cast<std::size_t>(channels) - 1, 100);
      pixels.push_back(i == 0 ? 0 : 128);
    }
    OIIO::ImageSpec spec = spec_of<std::uint8_t>(channels);
    spec.alpha_channel = channels - 1;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const char* pattern : {"s{}.png", "s{}.tif"}) {
      TemporaryFolder folder;
      for (int k = 0; k < 2; ++k)
        write_picture(folder / fmt::format(fmt::runtime(pattern), k), spec, pixels);
      const Volume volume = read_only_volume(folder.path());
      EXPECT_EQ(volume.value_range, (ValueRange{100, 100})) << pattern << channels;
      EXPECT_TRUE(has_warning(volume.description, warning)) << pattern << channels;
    }
  }
}

TEST(ImageStack, ASidecarThatIsALinkIsNotFollowed) {
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(elsewhere / "volume.json", kSidecar);
  write_stack<std::uint8_t>(folder.path(), "s{}.png", 3, spec_of<std::uint8_t>(1));
  fs::create_symlink(elsewhere / "volume.json", folder / "volume.json");
  const Listing listing = scan(folder.path());
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_EQ(listing.refused[0].path, folder / "volume.json");
  ASSERT_EQ(listing.volumes.size(), 1U);
  const VolumeSource& source = listing.volumes[0];
  EXPECT_NE(source.description.title, "A head");
  EXPECT_EQ(source.geometry.spacing_mm, glm::dvec3(1.0));
  EXPECT_TRUE(has_warning(source.description, "volume.json is a link"));
}

TEST(ImageStack, OneBrokenPictureRefusesItsStackByName) {
  for (const char* pattern : {"s{}.tif", "s{}.png"}) {
    TemporaryFolder folder;
    write_stack<std::uint16_t>(folder.path(), pattern, 4, spec_of<std::uint16_t>(1));
    const fs::path third = folder / fmt::format(fmt::runtime(pattern), 3);
    write_file(third, read_file(third).substr(0, 6));
    const Listing listing = scan(folder.path());
    EXPECT_TRUE(listing.volumes.empty());
    ASSERT_EQ(listing.refused.size(), 1U);
    EXPECT_EQ(listing.refused[0].path, third);
    EXPECT_NE(listing.refused[0].reason.find("stack of 4 pictures"), std::string::npos);
  }
}

TEST(ImageStack, CutOffPixelsFailWithTheName) {
  TemporaryFolder folder;
  write_stack<std::uint16_t>(folder.path(), "s{}.png", 3, spec_of<std::uint16_t>(1));
  const std::string whole = read_file(folder / "s2.png");
  const std::size_t data = whole.find("IDAT");
  ASSERT_NE(data, std::string::npos);
  write_file(folder / "s2.png", whole.substr(0, data + 10));
  const Listing listing = scan(folder.path());
  if (listing.volumes.empty()) return;  // seen at once is as good
  EXPECT_NE(read_failure(listing.volumes[0]).find("s2.png"), std::string::npos);
}

TEST(ImageStack, PicturesOfOtherSizesAreRefused) {
  TemporaryFolder folder;
  write_stack<std::uint8_t>(folder.path(), "s{}.png", 3, spec_of<std::uint8_t>(1));
  OIIO::ImageSpec other(7, 4, 1, OIIO::TypeDesc::UINT8);
  write_picture(folder / "s4.png", other, std::vector<std::uint8_t>(28, 1));
  EXPECT_NE(only_refusal(folder.path()).find("differs from the first"), std::string::npos);
}

TEST(ImageStack, ALonePictureIsNoVolume) {
  TemporaryFolder folder;
  write_picture(folder / "photo.png", spec_of<std::uint8_t>(1), page<std::uint8_t>(0));
  EXPECT_NE(only_refusal(folder.path()).find("single slice"), std::string::npos);
}

TEST(ImageStack, TheByteLimitHoldsBeforeDecoding) {
  TemporaryFolder folder;
  write_stack<std::uint16_t>(folder.path(), "s{}.tif", 4, spec_of<std::uint16_t>(1));
  const Listing listing = scan_volumes(folder.path(), folder.path(), {.volume_bytes = 159}, {});
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_NE(listing.refused[0].reason.find("too large"), std::string::npos);
  EXPECT_EQ(scan_volumes(folder.path(), folder.path(), {.volume_bytes = 160}, {}).volumes.size(),
            1U);
}

TEST(NaturalOrder, ComparesNumbersAsNumbers) {
  const reading::NaturalOrder before;
  EXPECT_TRUE(before("slice2", "slice10"));
  EXPECT_FALSE(before("slice10", "slice2"));
  EXPECT_TRUE(before("a1b2", "a1b10"));
  EXPECT_TRUE(before("1", "01"));
  EXPECT_TRUE(before("99999999999999999998", "99999999999999999999"));
  EXPECT_FALSE(before("x", "x"));
}

TEST(NaturalOrder, TheLastVaryingNumberCountsTheSlices) {
  using Names = std::vector<std::vector<std::string>>;
  EXPECT_EQ(reading::stacks_of_names({"b10.png", "b9.png", "a1.png"}),
            (Names{{"a1.png"}, {"b9.png", "b10.png"}}));
  EXPECT_EQ(reading::stacks_of_names({"s1_2.png", "s1_1.png", "s2_1.png", "s2_2.png"}),
            (Names{{"s1_1.png", "s1_2.png"}, {"s2_1.png", "s2_2.png"}}));
  EXPECT_EQ(reading::stacks_of_names({"2_of_3.png", "1_of_3.png"}),
            (Names{{"1_of_3.png", "2_of_3.png"}}));
}

}  // namespace
}  // namespace cutaway::test
