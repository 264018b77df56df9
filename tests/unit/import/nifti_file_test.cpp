// The values of a NIfTI file, and files that are none.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"

namespace cutaway::test {
namespace {

TEST(Nifti, ReadsGzipAlsoOfSeveralMembers) {
  NiftiFile nifti;
  const std::string bytes = nifti.with(nifti.ramp_voxels());
  TemporaryFolder folder;
  write_file(folder / "one.nii.gz", gzip(bytes));
  expect_ramp(read_only_volume(folder / "one.nii.gz"), 1e-2);
  write_file(folder / "two.nii.gz", gzip(bytes.substr(0, 500)) + gzip(bytes.substr(500)));
  expect_ramp(read_only_volume(folder / "two.nii.gz"), 1e-2);
}

TEST(Nifti, ReadsHeaderAndImagePairs) {
  NiftiFile nifti;
  nifti.magic = "ni1";
  TemporaryFolder folder;
  write_file(folder / "pair.hdr", nifti.header().substr(0, 348));
  write_file(folder / "pair.img", nifti.ramp_voxels());
  const VolumeSource source = only_source(folder.path(), folder.path());
  EXPECT_EQ(source.files.size(), 2U);
  expect_ramp(read(source), 1e-2);
}

TEST(Nifti, AnOffsetOfZeroMeansTheFirstPlaceForVoxels) {
  for (const int version : {1, 2}) {
    NiftiFile nifti{.version = version, .voxel_offset = 0};
    TemporaryFolder folder;
    write_file(folder / "zero.nii", nifti.with(nifti.ramp_voxels()));
    expect_ramp(read_only_volume(folder.path()), 1e-2);
  }
}

TEST(Nifti, VoxelsMayLieFurtherBehindTheHeader) {
  for (const int version : {1, 2}) {
    NiftiFile nifti{.version = version, .voxel_offset = 1000};
    std::string bytes = nifti.header();
    bytes.resize(1000);
    TemporaryFolder folder;
    write_file(folder / "far.nii", bytes + nifti.ramp_voxels());
    expect_ramp(read_only_volume(folder.path()), 1e-2);
  }
}

TEST(Nifti, AnImageThatLinksOutOfTheDataFolderIsRefused) {
  NiftiFile nifti;
  nifti.magic = "ni1";
  TemporaryFolder folder;
  TemporaryFolder elsewhere;
  write_file(elsewhere / "secret.img", nifti.ramp_voxels());
  write_file(folder / "pair.hdr", nifti.header().substr(0, 348));
  std::filesystem::create_symlink(elsewhere / "secret.img", folder / "pair.img");
  const Listing listing = scan(folder / "pair.hdr");
  EXPECT_TRUE(listing.volumes.empty());
  ASSERT_EQ(listing.refused.size(), 1U);
  EXPECT_NE(listing.refused[0].reason.find("outside of the data folder"), std::string::npos);
}

TEST(Nifti, HeaderWithoutItsImageIsRefused) {
  NiftiFile nifti;
  nifti.magic = "ni1";
  TemporaryFolder folder;
  write_file(folder / "alone.hdr", nifti.header().substr(0, 348));
  EXPECT_NE(only_refusal(folder.path()).find("alone.img"), std::string::npos);
}

template <typename T>
void expect_type(std::int16_t datatype, std::vector<T> values) {
  for (const bool big_endian : {false, true}) {
    NiftiFile nifti{.big_endian = big_endian, .dim = {2, 2, 2}, .datatype = datatype};
    TemporaryFolder folder;
    write_file(folder / "t.nii", nifti.with(bytes_of_numbers(values, big_endian)));
    const Volume volume = read_only_volume(folder.path());
    for (int i = 0; i < 8; ++i) {
      const auto expected = static_cast<double>(values[static_cast<std::size_t>(i)]);
      EXPECT_EQ(value_at(volume, {i % 2, i / 2 % 2, i / 4}), expected) << "type " << datatype;
    }
  }
}

TEST(Nifti, ReadsEveryNumberTypeInBothByteOrders) {
  expect_type<std::uint8_t>(2, {0, 1, 2, 3, 100, 200, 254, 255});
  expect_type<std::int8_t>(256, {-128, -1, 0, 1, 2, 3, 100, 127});
  expect_type<std::int16_t>(4, {-32768, -1000, -1, 0, 1, 255, 256, 32767});
  expect_type<std::uint16_t>(512, {0, 1, 255, 256, 1000, 32767, 32768, 65535});
  expect_type<std::int32_t>(8, {-1000000, -1, 0, 1, 2, 3, 65536, 1000000});
  expect_type<std::uint32_t>(768, {0, 1, 2, 3, 65535, 65536, 16777216, 1U << 31});
  expect_type<std::int64_t>(1024, {-5000000000, -1, 0, 1, 2, 3, 4, 5000000000});
  expect_type<std::uint64_t>(1280, {0, 1, 2, 3, 4, 5, 6, 1ULL << 40});
  expect_type<float>(16, {-1.5F, 0, 0.25F, 1, 2, 3, 4, 1e6F});
  expect_type<double>(64, {-1.5, 0, 0.25, 1, 2, 3, 4, 1e6});
}

TEST(Nifti, AppliesTheSlopeOnce) {
  NiftiFile nifti{.dim = {2, 2, 2}, .datatype = 2, .slope = 2.5, .intercept = -10};
  TemporaryFolder folder;
  write_file(folder / "s.nii",
             nifti.with(bytes_of_numbers<std::uint8_t>({0, 1, 2, 3, 4, 5, 6, 100})));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_DOUBLE_EQ(value_at(volume, {0, 0, 0}), -10);
  EXPECT_DOUBLE_EQ(value_at(volume, {1, 1, 1}), 240);
  EXPECT_DOUBLE_EQ(volume.value_range.maximum, 240);
}

TEST(Nifti, TakesTheFirstOfSeveralVolumesAndSaysSo) {
  NiftiFile nifti{.dim = {2, 2, 2, 3}, .datatype = 4};
  std::vector<std::int16_t> values(24, 77);
  for (int i = 0; i < 8; ++i) values[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(i);
  TemporaryFolder folder;
  write_file(folder / "t.nii", nifti.with(bytes_of_numbers(values)));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.value_range, (ValueRange{0, 7}));
  EXPECT_TRUE(has_warning(volume.description, "3 volumes"));
}

TEST(Nifti, ReducesColourToLuminanceAndSaysSo) {
  NiftiFile nifti{.dim = {2, 2, 2}, .datatype = 128};
  std::string voxels(24, '\0');
  voxels[0] = '\xFF';
  voxels[4] = '\xFF';
  TemporaryFolder folder;
  write_file(folder / "rgb.nii", nifti.with(voxels));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {0, 0, 0}), 54);   // 0.2126 * 255
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 182);  // 0.7152 * 255
  EXPECT_TRUE(has_warning(volume.description, "luminance"));
}

TEST(Nifti, VoxelsThatAreNoNumbersAreNothingAndCounted) {
  NiftiFile nifti{.dim = {2, 2, 2}};
  const float nan = std::nanf("");
  TemporaryFolder folder;
  write_file(folder / "nan.nii",
             nifti.with(bytes_of_numbers<float>({1, nan, 3, INFINITY, 5, 6, 7, 8})));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 0);
  EXPECT_TRUE(has_warning(volume.description, "2 voxels"));
  write_file(folder / "nan.nii", nifti.with(bytes_of_numbers(std::vector<float>(8, nan))));
  EXPECT_NE(read_failure(only_source(folder.path(), folder.path())).find("no voxel has a value"),
            std::string::npos);
}

TEST(Nifti, CallsPlainHounsfieldValuesCtAndSaysSo) {
  NiftiFile nifti{.dim = {2, 2, 2}, .datatype = 4};
  TemporaryFolder folder;
  write_file(folder / "ct.nii",
             nifti.with(bytes_of_numbers<std::int16_t>({-1024, 0, 40, 60, 300, 1200, -100, 5})));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.description.units, "HU");
  EXPECT_TRUE(has_warning(volume.description, "Hounsfield"));
}

struct BrokenFile {
  const char* name;
  std::function<std::string()> bytes;
  const char* reason;
};

class BrokenNifti : public testing::TestWithParam<BrokenFile> {};

TEST_P(BrokenNifti, IsListedWithItsReason) {
  TemporaryFolder folder;
  write_file(folder / "broken.nii", GetParam().bytes());
  const std::string reason = only_refusal(folder.path());
  EXPECT_NE(reason.find(GetParam().reason), std::string::npos) << reason;
}

std::string changed(const std::function<void(NiftiFile&)>& change) {
  NiftiFile nifti;
  change(nifti);
  return nifti.with(NiftiFile().ramp_voxels());
}

INSTANTIATE_TEST_SUITE_P(
    Files, BrokenNifti,
    testing::Values(
        BrokenFile{"empty", [] { return std::string(); }, "empty"},
        BrokenFile{"short_header", [] { return NiftiFile().header().substr(0, 100); },
                   "at least 348 bytes"},
        BrokenFile{"not_nifti", [] { return std::string(600, 'x'); }, "header size of 348 or 540"},
        BrokenFile{"analyze", [] { return changed([](auto& n) { n.magic = ""; }); }, "n+1"},
        BrokenFile{"truncated", [] { return changed([](auto&) {}).substr(0, 600); },
                   "shorter than its header says"},
        // 452 bytes that declare 70 TB.
        BrokenFile{"bomb",
                   [] {
                     NiftiFile nifti{.dim = {32000, 32000, 32000}, .datatype = 4};
                     return nifti.with(std::string(100, '\0'));
                   },
                   "59.6 TiB"},
        BrokenFile{"lying_gzip",
                   [] {
                     NiftiFile nifti{.dim = {1000, 1000, 1000}, .datatype = 4};
                     return gzip(nifti.with(std::string(1000, '\0')));
                   },
                   "shorter than its header says"},
        // The header's own bytes are no voxels.
        BrokenFile{"offset_in_header", [] { return changed([](auto& n) { n.voxel_offset = 16; }); },
                   "got 16"},
        BrokenFile{"offset_before_extensions",
                   [] { return changed([](auto& n) { n.voxel_offset = 351; }); },
                   "expected 0, or from 352 bytes on"},
        BrokenFile{"offset_in_header_2",
                   [] {
                     return changed([](auto& n) {
                       n.version = 2;
                       n.voxel_offset = 540;
                     });
                   },
                   "expected 0, or from 544 bytes on"},
        BrokenFile{"negative_offset", [] { return changed([](auto& n) { n.voxel_offset = -4; }); },
                   "got -4"},
        BrokenFile{"nan_offset", [] { return changed([](auto& n) { n.voxel_offset = NAN; }); },
                   "vox_offset"},
        BrokenFile{"offset_beyond_the_file",
                   [] { return changed([](auto& n) { n.voxel_offset = 1e6; }); },
                   "shorter than its header says"},
        BrokenFile{"negative_extent", [] { return changed([](auto& n) {
                                             n.dim = {-4, 5, 6};
                                           }); },
                   "empty grid"},
        BrokenFile{"single_slice", [] { return changed([](auto& n) {
                                          n.dim = {4, 5};
                                        }); },
                   "single slice"},
        BrokenFile{"complex", [] { return changed([](auto& n) { n.datatype = 32; }); },
                   "data type 32"},
        BrokenFile{"nan_sform", [] { return changed([](auto& n) { n.s_steps[0][0] = NAN; }); },
                   "not usable"},
        BrokenFile{"zero_sform", [] { return changed([](auto& n) {
                                        n.s_steps[2] = {0, 0, 0};
                                      }); },
                   "not usable"},
        BrokenFile{"nan_origin", [] { return changed([](auto& n) { n.s_origin.y = NAN; }); },
                   "not usable"},
        BrokenFile{"flat_sform",
                   [] { return changed([](auto& n) { n.s_steps[1] = n.s_steps[0]; }); },
                   "right angles"},
        BrokenFile{"negative_pixdim",
                   [] {
                     return changed([](auto& n) {
                       n.sform_code = 0;
                       n.qform_code = 1;
                       n.pixdim[2] = -1;
                     });
                   },
                   "got -1"},
        BrokenFile{"zero_pixdim",
                   [] {
                     return changed([](auto& n) {
                       n.sform_code = 0;
                       n.pixdim[1] = 0;
                     });
                   },
                   "above 0"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Nifti, CutOffGzipFailsWithWords) {
  NiftiFile nifti{.dim = {20, 20, 20}};
  const std::string whole = gzip(nifti.with(nifti.ramp_voxels()));
  TemporaryFolder folder;
  write_file(folder / "cut.nii.gz", whole.substr(0, whole.size() / 2));
  EXPECT_NE(read_failure(only_source(folder.path(), folder.path())).find("ends before"),
            std::string::npos);
  std::string spoiled = whole;
  spoiled.replace(spoiled.size() / 2, 20, std::string(20, '\xFF'));
  write_file(folder / "cut.nii.gz", spoiled);
  EXPECT_FALSE(read_failure(only_source(folder.path(), folder.path())).empty());
}

}  // namespace
}  // namespace cutaway::test
