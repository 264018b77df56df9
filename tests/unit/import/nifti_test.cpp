// Headers are written here field by field from the format's definition, so that the reader is
// checked against that.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

const glm::dmat3 kRasToLps(-1, 0, 0, 0, -1, 0, 0, 0, 1);

template <typename T>
void put(std::string& bytes, std::size_t offset, T number, bool big_endian) {
  const std::string raw = bytes_of_numbers<T>({number}, big_endian);
  bytes.replace(offset, raw.size(), raw);
}

struct NiftiFile {
  int version = 1;
  bool big_endian = false;
  std::string magic = "n+1";
  std::vector<std::int64_t> dim{4, 5, 6};
  std::int16_t datatype = 16;
  std::vector<double> pixdim{1, 1, 1, 1, 1, 1, 1, 1};
  double slope = 0;
  double intercept = 0;
  int units = 2;
  int qform_code = 0;
  int sform_code = 1;
  glm::dvec3 quaternion{0, 0, 0};
  glm::dvec3 q_offset{0, 0, 0};
  glm::dmat3 s_steps{1};  ///< RAS
  glm::dvec3 s_origin{0, 0, 0};

  std::string header() const {
    std::string bytes(352, '\0');
    const auto f32 = [&](std::size_t at, double v) {
      put(bytes, at, static_cast<float>(v), big_endian);
    };
    const auto i16 = [&](std::size_t at, std::int64_t v) {
      put(bytes, at, static_cast<std::int16_t>(v), big_endian);
    };
    put<std::int32_t>(bytes, 0, 348, big_endian);
    i16(40, static_cast<std::int64_t>(dim.size()));
    for (std::size_t i = 0; i < dim.size(); ++i) i16(42 + 2 * i, dim[i]);
    i16(70, datatype);
    for (std::size_t i = 0; i < 8; ++i) f32(76 + 4 * i, pixdim[i]);
    f32(108, magic[1] == '+' ? 352 : 0);
    f32(112, slope);
    f32(116, intercept);
    bytes[123] = static_cast<char>(units);
    i16(252, qform_code);
    i16(254, sform_code);
    for (int i = 0; i < 3; ++i) f32(256 + 4 * i, quaternion[i]);
    for (int i = 0; i < 3; ++i) f32(268 + 4 * i, q_offset[i]);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        f32(280 + 16 * row + 4 * column, s_steps[column][row]);
      f32(280 + 16 * row + 12, s_origin[row]);
    }
    bytes.replace(344, magic.size(), magic);
    return bytes;
  }

  std::string header_2() const {
    std::string bytes(544, '\0');
    const auto f64 = [&](std::size_t at, double v) { put(bytes, at, v, big_endian); };
    put<std::int32_t>(bytes, 0, 540, big_endian);
    bytes.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
    put(bytes, 12, datatype, big_endian);
    put(bytes, 16, static_cast<std::int64_t>(dim.size()), big_endian);
    for (std::size_t i = 0; i < dim.size(); ++i) put(bytes, 24 + 8 * i, dim[i], big_endian);
    for (std::size_t i = 0; i < 8; ++i) f64(104 + 8 * i, pixdim[i]);
    put<std::int64_t>(bytes, 168, 544, big_endian);
    f64(176, slope);
    f64(184, intercept);
    put<std::int32_t>(bytes, 344, qform_code, big_endian);
    put<std::int32_t>(bytes, 348, sform_code, big_endian);
    for (int i = 0; i < 3; ++i) f64(352 + 8 * i, quaternion[i]);
    for (int i = 0; i < 3; ++i) f64(376 + 8 * i, q_offset[i]);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        f64(400 + 32 * row + 8 * column, s_steps[column][row]);
      f64(400 + 32 * row + 24, s_origin[row]);
    }
    put<std::int32_t>(bytes, 500, units, big_endian);
    return bytes;
  }

  glm::ivec3 size() const { return {dim[0], dim[1], dim[2]}; }

  /// A ramp over the grid that the sform describes, as floats.
  std::string ramp_voxels() const {
    const auto values = ramp_values(size(), kRasToLps * s_steps, kRasToLps * s_origin);
    return bytes_of_numbers(std::vector<float>(values.begin(), values.end()), big_endian);
  }

  std::string with(const std::string& voxels) const {
    return (version == 2 ? header_2() : header()) + voxels;
  }
};

/// Rotation about an axis that is none of the patient's, times the spacing.
glm::dmat3 oblique_steps(glm::dvec3 spacing) {
  const glm::dvec3 i = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 j = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), i));
  const glm::dvec3 k = glm::cross(i, j);
  return {i * spacing.x, j * spacing.y, k * spacing.z};
}

struct Placement {
  const char* name;
  glm::dmat3 steps;
};

class NiftiPlacement : public testing::TestWithParam<Placement> {};

TEST_P(NiftiPlacement, FollowsTheSformIntoThePatient) {
  for (const int version : {1, 2}) {
    for (const bool big_endian : {false, true}) {
      NiftiFile nifti{.version = version, .big_endian = big_endian};
      nifti.s_steps = GetParam().steps;
      nifti.s_origin = {-31.5, 12.25, 40.75};
      TemporaryFolder folder;
      write_file(folder / "ramp.nii", nifti.with(nifti.ramp_voxels()));
      expect_ramp(read_only_volume(folder.path()), 1e-2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Orientations, NiftiPlacement,
    testing::Values(Placement{"axial", glm::dmat3(1.5, 0, 0, 0, 2.5, 0, 0, 0, 3)},
                    Placement{"left_handed", glm::dmat3(-1.5, 0, 0, 0, 2.5, 0, 0, 0, 3)},
                    Placement{"upside_down", glm::dmat3(1.5, 0, 0, 0, 2.5, 0, 0, 0, -3)},
                    Placement{"coronal", glm::dmat3(1.5, 0, 0, 0, 0, 2.5, 0, 3, 0)},
                    Placement{"sagittal", glm::dmat3(0, 1.5, 0, 0, 0, -2.5, 3, 0, 0)},
                    Placement{"oblique", oblique_steps({0.7, 1.1, 2.3})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Nifti, SizeSpacingAndDirectionAreThoseOfTheHeader) {
  NiftiFile nifti;
  nifti.s_steps = glm::dmat3(-2, 0, 0, 0, 3, 0, 0, 0, 4);
  nifti.s_origin = {10, 20, 30};
  TemporaryFolder folder;
  write_file(folder / "a.nii", nifti.with(nifti.ramp_voxels()));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.size_voxels, glm::ivec3(4, 5, 6));
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(2, 3, 4));
  EXPECT_EQ(volume.geometry.origin_patient_mm, glm::dvec3(-10, -20, 30));
  EXPECT_EQ(volume.geometry.direction_patient, glm::dmat3(1, 0, 0, 0, -1, 0, 0, 0, 1));
  EXPECT_EQ(volume.description.format, "NIfTI");
  EXPECT_EQ(volume.description.id, "a.nii");
  EXPECT_TRUE(volume.description.warnings.empty());
}

/// A quaternion of 90 degrees about z takes i to +y and j to -x (RAS); qfac = -1 turns k round.
TEST(Nifti, FollowsTheQformWhereThereIsNoSform) {
  NiftiFile nifti;
  nifti.sform_code = 0;
  nifti.qform_code = 1;
  nifti.pixdim = {-1, 2, 3, 4, 0, 0, 0, 0};
  nifti.quaternion = {0, 0, std::sqrt(0.5)};
  nifti.q_offset = {7, 8, 9};
  nifti.s_steps = glm::dmat3(0, 2, 0, -3, 0, 0, 0, 0, -4);
  nifti.s_origin = {7, 8, 9};
  TemporaryFolder folder;
  write_file(folder / "q.nii", nifti.with(nifti.ramp_voxels()));
  const Volume volume = read_only_volume(folder.path());
  expect_ramp(volume, 1e-2);
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 4, 1e-9);
}

TEST(Nifti, PrefersTheSform) {
  NiftiFile nifti;
  nifti.qform_code = 1;
  nifti.quaternion = {1, 0, 0};
  nifti.s_steps = glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 5);
  TemporaryFolder folder;
  write_file(folder / "both.nii", nifti.with(nifti.ramp_voxels()));
  expect_ramp(read_only_volume(folder.path()), 1e-2);
}

TEST(Nifti, WithoutAnyTransformWarns) {
  NiftiFile nifti;
  nifti.sform_code = 0;
  nifti.pixdim = {1, 2, 3, 4, 0, 0, 0, 0};
  TemporaryFolder folder;
  write_file(folder / "none.nii", nifti.with(nifti.ramp_voxels()));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(volume.geometry.spacing_mm, glm::dvec3(2, 3, 4));
  EXPECT_TRUE(has_warning(volume.description, "neither sform nor qform"));
}

TEST(Nifti, ConvertsMetresAndMicrometres) {
  for (const auto& [units, expected] : {std::pair(1, 2000.0), std::pair(3, 0.002)}) {
    NiftiFile nifti{.units = units};
    nifti.s_steps = glm::dmat3(2, 0, 0, 0, 2, 0, 0, 0, 2);
    TemporaryFolder folder;
    write_file(folder / "u.nii", nifti.with(nifti.ramp_voxels()));
    EXPECT_NEAR(only_source(folder.path(), folder.path()).geometry.spacing_mm.x, expected, 1e-9);
  }
}

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

TEST(Nifti, ShearedGridIsResampledAndSaysSo) {
  NiftiFile nifti{.dim = {12, 12, 8}};
  nifti.s_steps = glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0.6, 2);
  TemporaryFolder folder;
  write_file(folder / "sheared.nii", nifti.with(nifti.ramp_voxels()));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_TRUE(has_warning(volume.description, "resampled"));
  EXPECT_NEAR(volume.geometry.spacing_mm.z, 2, 1e-6);
  expect_ramp(volume, 1e-2, 0.4);
}

TEST(Nifti, VoxelsThatAreNoNumbersAreReplacedAndCounted) {
  NiftiFile nifti{.dim = {2, 2, 2}};
  const float nan = std::nanf("");
  TemporaryFolder folder;
  write_file(folder / "nan.nii",
             nifti.with(bytes_of_numbers<float>({1, nan, 3, INFINITY, 5, 6, 7, 8})));
  const Volume volume = read_only_volume(folder.path());
  EXPECT_EQ(value_at(volume, {1, 0, 0}), 1);
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

struct Broken {
  const char* name;
  std::function<std::string()> bytes;
  const char* reason;
};

class BrokenNifti : public testing::TestWithParam<Broken> {};

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
        Broken{"empty", [] { return std::string(); }, "empty"},
        Broken{"short_header", [] { return NiftiFile().header().substr(0, 100); },
               "at least 348 bytes"},
        Broken{"not_nifti", [] { return std::string(600, 'x'); }, "header size of 348 or 540"},
        Broken{"analyze", [] { return changed([](auto& n) { n.magic = ""; }); }, "n+1"},
        Broken{"truncated", [] { return changed([](auto&) {}).substr(0, 600); },
               "shorter than its header says"},
        // 452 bytes that declare 70 TB.
        Broken{"bomb",
               [] {
                 NiftiFile nifti{.dim = {32000, 32000, 32000}, .datatype = 4};
                 return nifti.with(std::string(100, '\0'));
               },
               "59.6 TiB"},
        Broken{"lying_gzip",
               [] {
                 NiftiFile nifti{.dim = {1000, 1000, 1000}, .datatype = 4};
                 return gzip(nifti.with(std::string(1000, '\0')));
               },
               "shorter than its header says"},
        Broken{"negative_extent", [] { return changed([](auto& n) {
                                         n.dim = {-4, 5, 6};
                                       }); },
               "empty grid"},
        Broken{"single_slice", [] { return changed([](auto& n) {
                                      n.dim = {4, 5};
                                    }); },
               "single slice"},
        Broken{"complex", [] { return changed([](auto& n) { n.datatype = 32; }); }, "data type 32"},
        Broken{"nan_sform", [] { return changed([](auto& n) { n.s_steps[0][0] = NAN; }); },
               "not usable"},
        Broken{"zero_sform", [] { return changed([](auto& n) {
                                    n.s_steps[2] = {0, 0, 0};
                                  }); },
               "not usable"},
        Broken{"nan_origin", [] { return changed([](auto& n) { n.s_origin.y = NAN; }); },
               "not usable"},
        Broken{"flat_sform", [] { return changed([](auto& n) { n.s_steps[1] = n.s_steps[0]; }); },
               "right angles"},
        Broken{"negative_pixdim",
               [] {
                 return changed([](auto& n) {
                   n.sform_code = 0;
                   n.qform_code = 1;
                   n.pixdim[2] = -1;
                 });
               },
               "got -1"},
        Broken{"zero_pixdim",
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
