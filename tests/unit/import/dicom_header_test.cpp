// Headers as writers leave them, and what is said of files that are not read.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "unit/import/dicom_writer.h"
#include "unit/import/import_test_support.h"
#include "unit/import/own_process.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

std::vector<DicomSlice> ramp_slices() { return ramp_series(4, {0, 0, 0}, {0, 0, 2}); }

struct OddVr {
  const char* name;
  DicomTag tag;
  const char* text;
  const char* vr;
};

class DicomVr : public testing::TestWithParam<OddVr> {};

TEST_P(DicomVr, ThatIsNotTheDictionarysIsTaken) {
  auto slices = with_text(ramp_slices(), GetParam().tag, GetParam().text);
  for (auto& slice : slices) slice.vrs[GetParam().tag] = GetParam().vr;
  TemporaryFolder folder;
  write_series(folder.path(), slices);
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(4, 4, 4));
  expect_ramp(volume, 0.6);
}

INSTANTIATE_TEST_SUITE_P(
    Elements, DicomVr,
    testing::Values(OddVr{"spacing", {0x0028, 0x0030}, "1\\1", "UT"},
                    OddVr{"spacing_lo", {0x0028, 0x0030}, "1\\1", "LO"},
                    OddVr{"spacing_un", {0x0028, 0x0030}, "1\\1", "UN"},
                    OddVr{"orientation", {0x0020, 0x0037}, "1\\0\\0\\0\\1\\0", "UT"},
                    OddVr{"intercept", {0x0028, 0x1052}, "0", "LT"},
                    OddVr{"slope", {0x0028, 0x1053}, "1", "UT"},
                    OddVr{"rows", {0x0028, 0x0010}, "4", "IS"},
                    OddVr{"bits", {0x0028, 0x0100}, "16", "UT"},
                    OddVr{"samples", {0x0028, 0x0002}, "1", "DS"},
                    OddVr{"photometric", {0x0028, 0x0004}, "MONOCHROME2", "UT"},
                    OddVr{"thickness", {0x0018, 0x0050}, "2", "UT"}),
    [](const auto& test) { return std::string(test.param.name); });

/// As old archives and some scanners write it, and under names that say nothing.
TEST(DicomHeader, WithoutPreambleAndExtensionIsFound) {
  for (const Syntax syntax : {Syntax::explicit_little, Syntax::implicit, Syntax::big_endian}) {
    TemporaryFolder folder;
    write_series(folder.path(), ramp_slices());
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder.path())) files.push_back(entry.path());
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (syntax != Syntax::explicit_little) transcode(files[k], syntax);
      strip_file_header(files[k]);
      fs::rename(files[k], folder / ("IM" + std::to_string(k)));
    }
    expect_ramp(read_only_volume(folder.path()), 0.6);
  }
}

TEST(DicomHeader, OfOtherFilesWithoutExtensionIsNotSeen) {
  TemporaryFolder folder;
  write_file(folder / "README", "Nothing of interest stands here, in several lines of text.\n");
  write_file(folder / "zeros", std::string(4096, '\0'));
  write_file(folder / "eights", std::string(4096, '\x08'));
  write_file(folder / "short", std::string("\x08\0\x05\0", 4));
  const Listing listing = scan(folder.path());
  EXPECT_TRUE(listing.volumes.empty());
  EXPECT_TRUE(listing.refused.empty());
}

TEST(DicomHeader, UnreadTransferSyntaxesAreCalledByTheirNames) {
  const std::pair<const char*, const char*> syntaxes[]{
      {"1.2.840.10008.1.2.4.201", "HTJ2K"}, {"1.2.840.10008.1.2.4.203", "HTJ2K"},
      {"1.2.840.10008.1.2.4.102", "MPEG"},  {"1.2.840.10008.1.2.4.110", "JPEG XL"},
      {"1.2.840.10008.1.2.4.94", "JPIP"},   {"1.2.3.4.5.6", "1.2.3.4.5.6"}};
  for (const auto& [uid, name] : syntaxes) {
    TemporaryFolder folder;
    write_dicom(folder / "a.dcm", ramp_slices().front());
    rename_syntax(folder / "a.dcm", uid);
    const std::string reason = only_refusal(folder.path());
    EXPECT_NE(reason.find("transfer syntax"), std::string::npos) << reason;
    EXPECT_NE(reason.find(name), std::string::npos) << reason;
    EXPECT_EQ(reason.find("broken"), std::string::npos) << reason;
  }
}

TEST(DicomHeader, ObjectsThatAreNoImagesAreCalledByTheirNames) {
  const std::pair<const char*, const char*> classes[]{
      {"1.2.840.10008.1.3.10", "DICOMDIR"},
      {"1.2.840.10008.5.1.4.1.1.66.4", "SEG"},
      {"1.2.840.10008.5.1.4.1.1.66.7", "label map"},
      {"1.2.840.10008.5.1.4.1.1.481.3", "RTSTRUCT"},
      {"1.2.840.10008.5.1.4.1.1.88.33", "structured report"},
      {"1.2.840.10008.5.1.4.1.1.11.1", "presentation state"},
      {"1.2.840.10008.5.1.4.1.1.104.1", "encapsulated document"}};
  for (const auto& [uid, name] : classes) {
    TemporaryFolder folder;
    write_series(folder.path(), ramp_slices());
    DicomSlice other = ramp_slices().front();
    other.storage_class = uid;
    write_dicom(folder / "other.dcm", other);
    const Listing listing = scan(folder.path());
    ASSERT_EQ(listing.volumes.size(), 1U);
    ASSERT_EQ(listing.refused.size(), 1U);
    EXPECT_NE(listing.refused[0].reason.find(name), std::string::npos) << listing.refused[0].reason;
  }
}

constexpr std::int64_t kLittleGrowth = 64 << 20;

std::int64_t growth_bytes(const std::function<void()>& work) {
  return in_own_process([&] {
    const std::int64_t before = peak_bytes(RUSAGE_SELF);
    work();
    return peak_bytes(RUSAGE_SELF) - before;
  });
}

/// A length is a wish: nothing is allocated by it.
TEST(DicomHeader, LengthsBeyondTheFileCostNothing) {
  using namespace std::string_literals;
  const std::string heads[]{"\x08\0\x05\0\0\0\0\xF0"s, "\x08\0\x05\0OB\0\0\0\0\0\xF0"s,
                            "\x08\0\x05\0SQ\0\0\0\0\0\xF0"s, "\x02\0\x10\0UI\xF0\xFF"s,
                            "\xE0\x7F\x10\0OB\0\0\0\0\0\xF0"s};
  for (const auto& head : heads) {
    for (const std::string& mark : {""s, std::string(128, '\0') + "DICM"}) {
      TemporaryFolder folder;
      write_file(folder / "a.dcm", mark + head + std::string(28 - head.size(), 'x'));
      EXPECT_LT(growth_bytes([&] { scan(folder.path()); }), kLittleGrowth);
      EXPECT_FALSE(only_refusal(folder.path()).empty());
    }
  }
}

/// What a compressed picture says of its size is held against the header.
TEST(DicomHeader, ACompressedPictureOfAnotherSizeIsNotDecoded) {
  for (const Syntax syntax : {Syntax::jpeg_2000, Syntax::jpeg_ls, Syntax::jpeg_lossless}) {
    DicomSlice like;
    like.size_px = {16, 16};
    like.bits_stored = 12;
    like.is_signed = false;
    TemporaryFolder folder;
    write_series(folder.path(), ramp_series(2, {0, 0, 0}, {0, 0, 2}, like));
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      transcode(entry.path(), syntax);
      std::string bytes = read_file(entry.path());
      const std::size_t picture = syntax == Syntax::jpeg_2000 ? bytes.rfind("\xFF\x4F\xFF\x51")
                                                              : bytes.rfind("\xFF\xD8\xFF");
      const bool is_long = syntax == Syntax::jpeg_2000;
      const std::string size = is_long ? std::string("\0\0\0\x10", 4) : std::string("\0\x10", 2);
      for (std::size_t at = picture; (at = bytes.find(size + size, at)) != bytes.npos; at += 8)
        bytes.replace(at + size.size() - 2, 1, "\x75");  // 16 becomes 29968
      write_file(entry.path(), bytes);
    }
    const VolumeSource source = only_source(folder.path(), folder.path());
    EXPECT_LT(growth_bytes([&] { read_failure(source); }), kLittleGrowth);
    const std::string failure = read_failure(source);
    EXPECT_NE(failure.find("is not what the header says"), std::string::npos) << failure;
  }
}

}  // namespace
}  // namespace cutaway::test
