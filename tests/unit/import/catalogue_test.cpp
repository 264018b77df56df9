// The real volumes against what independent tools (pydicom, nibabel) say of them.
#include <gtest/gtest.h>

#include <cstdlib>

#include "unit/import/import_test_support.h"

namespace cutaway::test {
namespace {

struct Entry {
  const char* path;  ///< a folder or file that holds one volume
  glm::ivec3 size;
  glm::dvec3 spacing_mm;
  glm::dvec3 origin_lps_mm;
  glm::dvec3 axis_signs;  ///< all have axes along the patient's
  ValueRange range;
  const char* units;
};

void PrintTo(const Entry& entry, std::ostream* out) { *out << entry.path; }

class Catalogue : public testing::TestWithParam<Entry> {};

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance, const char* what) {
  EXPECT_LE(glm::length(a - b), tolerance) << what << ": " << a.x << " " << a.y << " " << a.z
                                           << " for " << b.x << " " << b.y << " " << b.z;
}

TEST_P(Catalogue, VolumeAgrees) {
  const char* data = std::getenv("CUTAWAY_TEST_DATA");
  if (!data) GTEST_SKIP() << "CUTAWAY_TEST_DATA does not name the folder of real volumes";
  const std::filesystem::path path = std::filesystem::path(data) / GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const VolumeSource source = only_source(path, data);
  const Volume volume = read(source);
  const Entry& entry = GetParam();
  EXPECT_EQ(source.geometry, volume.geometry) << "headers and voxels tell the same geometry";
  EXPECT_EQ(volume.geometry.size_voxels, entry.size);
  expect_near(volume.geometry.spacing_mm, entry.spacing_mm, 1e-5, "spacing");
  expect_near(volume.geometry.origin_patient_mm, entry.origin_lps_mm, 1e-5, "origin");
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 expected(0.0);
    expected[axis] = entry.axis_signs[axis];
    expect_near(volume.geometry.direction_patient[axis], expected, 1e-5, "direction");
  }
  EXPECT_NEAR(volume.value_range.minimum, entry.range.minimum, 1e-3);
  EXPECT_NEAR(volume.value_range.maximum, entry.range.maximum, 1e-3);
  EXPECT_EQ(volume.description.units, entry.units);
  EXPECT_TRUE(source.description.id.starts_with(entry.path)) << source.description.id;
}

INSTANTIATE_TEST_SUITE_P(
    RealVolumes, Catalogue,
    testing::Values(
        Entry{"chest_ct_lidc0314_dicom",
              {512, 512, 275},
              {0.78125, 0.78125, 1.0},
              {-201, -59, -679.800049},
              {1, 1, 1},
              {-1000, 1979},
              "HU"},
        Entry{"abdomen_ct_totalseg_nii/example_ct.nii.gz",
              {122, 101, 112},
              {3, 3, 3},
              {177.95632935, -11.31900024, 94.30175781},
              {-1, -1, 1},
              {-1207, 3382},
              "HU"},
        Entry{"aorta_cta_totalseg_nii/ct_cropped.nii.gz",
              {120, 126, 164},
              {1.5, 1.5, 1.5},
              {-71.65820312, -255.65820312, 540.20001221},
              {1, 1, 1},
              {-1078, 3343},
              "HU"},
        // The sidecar takes the stored 0..3272 to Hounsfield units.
        Entry{"head_ct_stanford_tiff",
              {256, 256, 99},
              {1, 1, 2},
              {0, 0, 0},
              {1, 1, -1},
              {-1024, 2248},
              "HU"},
        Entry{"head_mr_seg3d_nii",
              {160, 232, 160},
              {1.0, 0.898437, 0.898437},
              {388.26000977, 81.11995697, 405.42098999},
              {-1, -1, 1},
              {0, 512.00003},
              "none"},
        Entry{"stent_cta_nrrd", {128, 128, 256}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}, {0, 1}, "none"}),
    [](const auto& test) {
      const std::string path = test.param.path;
      return path.substr(0, path.find('/'));
    });

}  // namespace
}  // namespace cutaway::test
