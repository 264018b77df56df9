// What reading takes of memory, seen from outside: by the reader's process and by the one that
// takes over what it has read.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "import/isolation/voxel_transfer.h"
#include "unit/import/dicom_writer.h"
#include "unit/import/isolated_test_support.h"
#include "unit/import/own_process.h"
#include "unit/import/picture_writer.h"

namespace cutaway::test {
namespace {

namespace fs = std::filesystem;

struct Peaks {
  std::int64_t reader = 0;
  std::int64_t taker = 0;
};

/// Of a process that has had no other child and held no other volume.
Peaks peaks_of_reading(const VolumeSource& source) {
  return in_own_process([&] {
    const std::int64_t before = peak_bytes(RUSAGE_SELF);
    read_volume_isolated(worker(), source, {}, {}, {});
    return Peaks{peak_bytes(RUSAGE_CHILDREN), peak_bytes(RUSAGE_SELF) - before};
  });
}

std::int64_t voxels_of(const VolumeSource& source) {
  const glm::ivec3 size = source.geometry.size_voxels;
  return std::int64_t{size.x} * size.y * size.z;
}

constexpr std::int64_t kLittle = 64 << 20;

/// `decoded_bytes`: of a voxel as it is in the file, or as a Volume keeps it, whichever is more.
void expect_bounded(const VolumeSource& source, std::int64_t decoded_bytes,
                    std::int64_t baseline = 0) {
  const std::int64_t bytes = voxels_of(source) * decoded_bytes;
  ASSERT_GT(bytes, 2 * kLittle + (30 << 20)) << "too small to tell one copy from two";
  const Peaks peaks = peaks_of_reading(source);
  testing::Test::RecordProperty("volume_mib", static_cast<int>(bytes >> 20));
  testing::Test::RecordProperty("reader_mib", static_cast<int>(peaks.reader >> 20));
  testing::Test::RecordProperty("taker_mib", static_cast<int>(peaks.taker >> 20));
  EXPECT_GT(peaks.reader, bytes / 4) << "measured something else";
  EXPECT_LT(peaks.reader - baseline, bytes * 3 / 2 + kLittle);
  EXPECT_LT(peaks.taker, bytes * 3 / 2 + kLittle);
}

class ReadingMemory : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "a sanitizer's shadow memory counts, too";
#endif
  }

  /// Most of it is a hole in the file, so that it takes no time to be written.
  VolumeSource nrrd(const std::string& type, std::int64_t voxel_bytes, glm::ivec3 size,
                    const std::string& rest, std::string_view front) {
    const std::string header =
        "NRRD0004\ntype: " + type + "\nendian: little\nencoding: raw\n" + rest + "\n";
    const fs::path file = folder_ / "a.nrrd";
    write_file(file, header + std::string(front));
    const std::int64_t bytes = voxel_bytes * size.x * size.y * size.z;
    fs::resize_file(file, header.size() + static_cast<std::uintmax_t>(bytes));
    return only_source(folder_.path(), folder_.path());
  }

  VolumeSource nrrd(const std::string& type, std::int64_t voxel_bytes, const std::string& k_step,
                    std::string_view front) {
    return nrrd(type, voxel_bytes, {512, 512, 320},
                "dimension: 3\nspace: LPS\nsizes: 512 512 320\n"
                "space directions: (1,0,0) (0,1,0) " +
                    k_step + "\nspace origin: (0,0,0)\n",
                front);
  }

  TemporaryFolder folder_;
};

constexpr const char* kStraight = "(0,0,1)";
constexpr const char* kTilted = "(0,0.1,1)";

TEST_F(ReadingMemory, OfEightAndSixteenBits) {
  expect_bounded(nrrd("uint8", 1, kStraight, "abc"), 2);
  expect_bounded(nrrd("int16", 2, kStraight, "abc"), 2);
}

TEST_F(ReadingMemory, OfFloatsWithHoles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_bounded(nrrd("float", 4, kStraight, bytes_of_numbers<float>({nan, 0.5F})), 4);
}

TEST_F(ReadingMemory, OfDoubles) {
  expect_bounded(nrrd("double", 8, kStraight, bytes_of_numbers<double>({0.5})), 8);
}

TEST_F(ReadingMemory, OfWhatIsResampled) { expect_bounded(nrrd("int16", 2, kTilted, "abc"), 2); }

TEST_F(ReadingMemory, OfTwoValuesAVoxel) {
  expect_bounded(nrrd("int16", 4, {512, 512, 320},
                      "dimension: 4\nspace: LPS\nsizes: 2 512 512 320\nkinds: list domain domain "
                      "domain\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
                      "space origin: (0,0,0)\n",
                      "abc"),
                 4);
}

std::vector<DicomSlice> large_slices(glm::dvec3 step) {
  DicomSlice like;
  like.size_px = {2048, 2048};
  like.shorts = {{{0x0028, 0x0120}, -2000, true}};
  std::vector<DicomSlice> slices(24, like);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    slices[k].position_mm = step * static_cast<double>(k);
    slices[k].stored.resize(std::size_t{2048} * 2048);
    for (std::size_t i = 0; i < slices[k].stored.size(); ++i)
      slices[k].stored[i] = static_cast<std::int16_t>(i % 2048 < 10 ? -2000 : i % 500);
  }
  return slices;
}

TEST_F(ReadingMemory, OfDicomWithPadding) {
  write_series(folder_.path(), large_slices({0, 0, 2}));
  expect_bounded(only_source(folder_.path(), folder_.path()), 2);
}

TEST_F(ReadingMemory, OfTiltedDicomWithPadding) {
  write_series(folder_.path(), large_slices({0, 1, 2}));
  expect_bounded(only_source(folder_.path(), folder_.path()), 2);
}

TEST_F(ReadingMemory, OfCompressedDicom) {
  write_series(folder_.path(), large_slices({0, 0, 2}));
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    transcode(entry.path(), Syntax::rle);
  expect_bounded(only_source(folder_.path(), folder_.path()), 2);
}

void deflate_data_set(const fs::path& file) {
  std::uint32_t group_length = 0;  // of group 0002, which stays as it is
  std::memcpy(&group_length, read_file(file).data() + 140, sizeof(group_length));
  const auto plain_bytes = fs::file_size(file);
  rename_syntax(file, "1.2.840.10008.1.2.1.99");
  const std::string bytes = read_file(file);
  const std::size_t head = 144 + group_length + bytes.size() - plain_bytes;
  write_file(file, bytes.substr(0, head) + zlib(std::string_view(bytes).substr(head)));
}

/// All of its data set is one deflated stream.
TEST_F(ReadingMemory, OfADeflatedFileOfManyFrames) {
  write_enhanced_dicom(folder_ / "a.dcm", large_slices({0, 0, 2}));
  deflate_data_set(folder_ / "a.dcm");
  expect_bounded(only_source(folder_.path(), folder_.path()), 2);
}

/// OpenImageIO's libraries alone take more than the little that is allowed.
TEST_F(ReadingMemory, OfPictures) {
  const auto write_stack = [&](const std::string& name, unsigned size, int count) {
    PngPicture picture{{size, size}, 8, 2, {}, std::size_t{3} * size};
    picture.pixels.assign(picture.row_bytes * size, 'x');
    picture.pixels.front() = 'a';
    const std::string bytes = png_bytes(picture);
    for (int k = 0; k < count; ++k)
      write_file(folder_ / name / (std::to_string(k) + ".png"), bytes);
    return only_source(folder_ / name, folder_.path());
  };
  const Peaks libraries = peaks_of_reading(write_stack("tiny", 8, 2));
  expect_bounded(write_stack("large", 2048, 24), 2, libraries.reader);
}

/// What is handed on takes memory in one of the two processes or in the file between them.
TEST(VoxelTransfer, LeavesNothingInTheFile) {
  const reading::Descriptor file = reading::make_memory_file("voxels");
  std::vector<std::uint16_t> voxels(std::size_t{20} << 20);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::uint16_t>(i * 7);
  reading::hand_over(voxels, file.get());
  const auto blocks = [&] {
    struct stat status {};
    fstat(file.get(), &status);
    return status.st_blocks;
  };
  EXPECT_GE(blocks() * 512, static_cast<std::int64_t>(voxels.size() * 2));
  EXPECT_EQ(reading::take_over<std::uint16_t>(file, voxels.size()), voxels);
  EXPECT_EQ(blocks(), 0);
}

/// A byte a voxel becomes two: held against the limit from the header.
TEST(ReadingLimit, CountsWhatAVolumeKeeps) {
  TemporaryFolder folder;
  write_file(folder / "a.nrrd",
             "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n\n" +
                 std::string(512, 'x'));
  const auto scanned = [&](std::uint64_t limit) {
    return scan_volumes(folder.path(), folder.path(), {.volume_bytes = limit}, {});
  };
  EXPECT_EQ(scanned(1024).volumes.size(), 1U);
  ASSERT_EQ(scanned(1023).refused.size(), 1U);
  EXPECT_NE(scanned(1023).refused[0].reason.find("1.0 KiB (8x8x8 voxels)"), std::string::npos)
      << scanned(1023).refused[0].reason;
}

}  // namespace
}  // namespace cutaway::test
