// From the transforms of a NIfTI header to the patient.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/import/import_test_support.h"
#include "unit/import/nifti_writer.h"

namespace cutaway::test {
namespace {

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

/// Some writers set the sform's code and no sform.
TEST(Nifti, AnUnusableSformGivesWayToAGoodQform) {
  for (const glm::dmat3& steps :
       {glm::dmat3(0.0), glm::dmat3(NAN), glm::dmat3(1, 0, 0, 1, 0, 0, 0, 0, 1)}) {
    TemporaryFolder folder;
    NiftiFile nifti;
    nifti.pixdim = {1, 1, 1.5, 2, 1, 1, 1, 1};
    nifti.s_steps = glm::dmat3(1, 0, 0, 0, 1.5, 0, 0, 0, 2);
    nifti.s_origin = nifti.q_offset = {-12, -15, -10};
    const std::string voxels = nifti.ramp_voxels();
    nifti.qform_code = 1;
    nifti.s_steps = steps;
    write_file(folder / "a.nii", nifti.with(voxels));
    const Volume volume = read_only_volume(folder / "a.nii");
    expect_ramp(volume, 1e-3);
    EXPECT_TRUE(has_warning(volume.description, "the sform is not usable; the qform was taken"));
  }
}

TEST(Nifti, AnUnusableQformBesideAGoodSformDoesNotMatter) {
  TemporaryFolder folder;
  NiftiFile nifti;
  nifti.qform_code = 1;
  nifti.quaternion = {3, 3, 3};
  nifti.pixdim = {1, 0, 0, 0, 0, 0, 0, 0};
  write_file(folder / "a.nii", nifti.with(nifti.ramp_voxels()));
  expect_ramp(read_only_volume(folder / "a.nii"), 1e-3);
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

/// What no slice covers is air, also where air is the largest stored number.
TEST(Nifti, ShearedGridOfANegativeSlopeHasAirAroundIt) {
  NiftiFile nifti{.dim = {12, 12, 8}, .slope = -1};
  nifti.s_steps = glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0.6, 2);
  std::string voxels = nifti.ramp_voxels();
  constexpr std::size_t kSignByte = 3;
  for (std::size_t i = kSignByte; i < voxels.size(); i += sizeof(float)) {
    voxels[i] = static_cast<char>(voxels[i] ^ '\x80');
  }
  TemporaryFolder folder;
  write_file(folder / "negated.nii", nifti.with(voxels));
  expect_ramp(read_only_volume(folder.path()), 1e-2, 0.4);
}

}  // namespace
}  // namespace cutaway::test
