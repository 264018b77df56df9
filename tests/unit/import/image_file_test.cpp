// Pictures that lie, are cut off, or have many pages.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "import/pictures/tiff_pages.h"
#include "unit/import/import_test_support.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

/// Every pixel is 7.
void write_even(const fs::path& file, const OIIO::ImageSpec& spec) {
  fs::create_directories(file.parent_path());
  const std::vector<std::uint16_t> pixels(spec.image_pixels(), 7);
  const auto output = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(output && output->open(file.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT16, pixels.data()));
  ASSERT_TRUE(output->close());
}

/// OpenImageIO itself fills what is missing with zeros and calls it read.
TEST(ImageFile, CutOffOrBrokenTiffPixelsFailWithTheName) {
  std::string pixels;
  for (int i = 0; i < 40; ++i) pixels += static_cast<char>(i * i);
  std::string spoiled = zlib(pixels);
  spoiled[2] = '\xFF';  // a block of no known kind
  const std::pair<TiffPicture, std::size_t> pictures[]{
      {{.pixels = pixels}, 10},
      {{.pixels = pixels}, pixels.size()},
      {{.pixels = zlib(pixels), .compression = 8}, 12},
      {{.pixels = spoiled, .compression = 8}, 0},
      {{.pixels = "\xFF\xFF\xFF\xFF\xFF\xFF", .compression = 5}, 0}};
  for (const auto& [picture, missing] : pictures) {
    TemporaryFolder folder;
    for (const char* name : {"s0.tif", "s2.tif"})
      write_file(folder / name, tiff_bytes({.pixels = pixels}));
    const std::string bytes = tiff_bytes(picture);
    write_file(folder / "s1.tif", bytes.substr(0, bytes.size() - missing));
    const VolumeSource source = only_source(folder.path(), folder.path());
    EXPECT_NE(read_failure(source).find("s1.tif"), std::string::npos)
        << "compression " << picture.compression << ", " << missing << " bytes missing";
  }
}

/// Within the limit of bytes, but a file of some hundred bytes holds no such picture.
TEST(ImageFile, ALyingSizeIsRefusedFromTheHeader) {
  const glm::uvec2 huge(30000, 30000);
  const std::pair<const char*, std::string> pictures[]{
      {".png", png_bytes({.size_px = huge, .bits = 16, .pixels = "0123456789", .row_bytes = 10})},
      {".png", png_bytes({.size_px = huge, .pixels = "01234"})},
      {".tif", tiff_bytes({.size_px = huge, .pixels = std::string(40, 'v')})},
      {".tif", tiff_bytes({.size_px = huge, .pixels = zlib("v"), .compression = 8})},
      {".tif", tiff_bytes({.size_px = huge, .pixels = "v", .compression = 5})}};
  for (const auto& [ending, bytes] : pictures) {
    TemporaryFolder folder;
    for (const char* number : {"1", "2"})
      write_file(folder / (number + std::string(ending)), bytes);
    const std::string reason = only_refusal(folder.path());
    EXPECT_NE(reason.find("shorter than its header says; expected at least"), std::string::npos)
        << ending << ": " << reason;
  }
}

TEST(ImageFile, EvenPicturesThatCompressWellAreNoLie) {
  TemporaryFolder folder;
  OIIO::ImageSpec spec(2000, 2000, 1, OIIO::TypeDesc::UINT16);
  for (const char* compression : {"zip", "lzw", "packbits", "none"}) {
    spec.attribute("compression", compression);
    for (int k = 0; k < 2; ++k) {
      write_even(folder / fmt::format("{}/s{}.tif", compression, k), spec);
    }
    EXPECT_EQ(read_only_volume(folder / compression).value_range, (ValueRange{7, 7}));
  }
}

TEST(ImageFile, APageThatDiffersIsNamed) {
  TemporaryFolder folder;
  std::string bytes = tiff_bytes({.pixels = std::string(40, 'v'), .pages = 3});
  const std::string width = bytes.substr(10, 12);  // the first field of a page
  bytes.replace(bytes.rfind(width) + 8, 1, "\x04");
  write_file(folder / "pages.tif", bytes);
  EXPECT_NE(only_refusal(folder.path()).find("page 3 differs from the first"), std::string::npos);
}

TEST(ImageFile, PagesBeyondTheLimitAreNotDroppedInSilence) {
  TemporaryFolder folder;
  write_file(folder / "pages.tif", tiff_bytes({.pixels = std::string(40, 'v'), .pages = 32769}));
  EXPECT_NE(only_refusal(folder.path()).find("too many pages; expected at most 32768"),
            std::string::npos);
}

TEST(TiffPages, FollowsTheChainInBothByteOrdersToTheLimit) {
  TemporaryFolder folder;
  for (const bool big_endian : {false, true}) {
    write_file(folder / "a.tif", tiff_bytes({.big_endian = big_endian, .pages = 7}));
    EXPECT_EQ(reading::tiff_pages(folder / "a.tif", 100).count, 7);
    EXPECT_EQ(reading::tiff_pages(folder / "a.tif", 6).count, 7);
    EXPECT_EQ(reading::tiff_pages(folder / "a.tif", 3).count, 4);
  }
  write_file(folder / "a.png", png_bytes({}));
  EXPECT_EQ(reading::tiff_pages(folder / "a.png", 100).count, 0);
}

TEST(TiffPages, AChainInACircleEndsAtTheLimit) {
  TemporaryFolder folder;
  std::string bytes = tiff_bytes({});
  bytes.replace(8 + 2 + 14 * 12, 4, bytes_of_numbers<std::uint32_t>({8}));
  write_file(folder / "a.tif", bytes);
  EXPECT_EQ(reading::tiff_pages(folder / "a.tif", 50).count, 51);
}

TEST(TiffPages, KnowsBigTiff) {
  const auto shorts = bytes_of_numbers<std::uint16_t>;
  const auto longs = bytes_of_numbers<std::uint64_t>;
  std::string bytes = "II" + shorts({43, 8, 0}, false) + longs({16}, false);
  for (const std::uint64_t next : {16 + 36, 0}) {
    bytes += longs({1}, false) + shorts({256, 3}, false) + longs({1}, false) +
             shorts({5, 0, 0, 0}, false) + longs({next}, false);
  }
  TemporaryFolder folder;
  write_file(folder / "a.tif", bytes);
  const auto pages = reading::tiff_pages(folder / "a.tif", 100);
  EXPECT_EQ(pages.count, 2);
  EXPECT_FALSE(pages.first_that_differs);
}

}  // namespace
}  // namespace cutaway::test
