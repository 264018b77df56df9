// Normals in the surface buffer: exact where central differences are, and near enough elsewhere.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kNormalsViewport{120, 120};

/// The angle by which a GPU's own filter, which places samples to 1/256 of a voxel, may turn a
/// gradient; a software rasteriser's is exact.
double filter_error_degrees() { return GpuHarness::instance().context().is_software() ? 0.0 : 0.2; }

Scene surface_scene(const std::shared_ptr<const LoadedVolume>& volume, double iso_value,
                    const char* reconstruction = "linear") {
  return scene_for({{"camera",
                     {{"projection", "perspective"},
                      {"eye_mm", {70, -190, 45}},
                      {"target_mm", {0, 0, 0}},
                      {"up", {0, 0, 1}},
                      {"vertical_fov_degrees", 28}}},
                    {"context",
                     {{"surface", {{"iso_value", iso_value}}},
                      {"normals", {{"reconstruction", reconstruction}}},
                      {"shading", {{"name", "gooch"}}},
                      {"filters", Json::array()}}},
                    {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
                   volume, kNormalsViewport);
}

/// How far normals are from the field's at the points where rays meet the surface.
struct NormalErrors {
  double worst_degrees = 0.0;
  int looked_at = 0;
};

template <typename Gradient>
NormalErrors normal_errors(const std::shared_ptr<const LoadedVolume>& volume, double iso_value,
                           Gradient&& gradient_at, bool is_cubic = false) {
  const Scene scene = surface_scene(volume, iso_value, is_cubic ? "cubic" : "linear");
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const auto surface = is_cubic ? FramePipeline::read_calmed(gpu.view(), kContext)
                                : FramePipeline::read_surface(gpu.view(), kContext);
  const glm::dmat4 to_index = patient_to_index(volume->volume.geometry);
  const glm::dvec3 last(volume->volume.geometry.size_voxels - 1);
  NormalErrors errors;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (surface[i].w < 0.0F) continue;
    const glm::dvec2 pixel(i % kNormalsViewport.width_px, i / kNormalsViewport.width_px);
    const ViewRay ray = ray_through(scene.camera, scene.viewport, pixel + 0.5);
    const glm::dvec3 point_mm = ray.origin_mm + double(surface[i].w) * ray.direction;
    const glm::dvec3 index(to_index * glm::dvec4(point_mm, 1.0));
    // At the border differences are one-sided.
    if (glm::any(glm::lessThan(glm::min(index, last - index), glm::dvec3(1.0)))) continue;
    const glm::dvec3 expected = -glm::normalize(gradient_at(point_mm));
    const glm::dvec3 normal(surface[i]);
    EXPECT_NEAR(glm::length(normal), 1.0, 1e-5);
    const double sine = glm::length(glm::cross(expected, normal));
    errors.worst_degrees = std::max(errors.worst_degrees, glm::degrees(std::asin(sine)));
    // Towards the viewer; not so the spline's own at an outline, which lies elsewhere by a little.
    EXPECT_LE(glm::dot(normal, ray.direction), is_cubic ? 0.02 : 1e-6);
    ++errors.looked_at;
  }
  return errors;
}

class NormalsOnEveryGrid : public testing::TestWithParam<std::tuple<glm::dvec3, glm::dmat3>> {
 protected:
  VolumeGeometry geometry() const {
    const auto [spacing, direction] = GetParam();
    return centred_geometry(glm::ivec3(96.0 / spacing), spacing, direction);
  }
};

/// An ellipsoid, askew: mixed terms and three different curvatures.
constexpr QuadraticField kEllipsoid{
    .constant = 1000.0,
    .linear = {2.0, -3.0, 1.5},
    .quadratic = {{-1.0, 0.3, -0.2}, {0.1, -0.7, 0.25}, {0.2, -0.15, -1.3}}};

TEST_P(NormalsOnEveryGrid, OfAQuadraticFieldAreExact) {
  const auto volume = load(quadratic_volume(geometry(), kEllipsoid));
  const NormalErrors errors = normal_errors(
      volume, 0.0, [&](glm::dvec3 point_mm) { return kEllipsoid.gradient_per_mm(point_mm); });
  EXPECT_GT(errors.looked_at, 3000);
  EXPECT_LE(errors.worst_degrees, 0.005 + filter_error_degrees());  // floats
}

// The spline of a quadratic field is the field and a constant: its slope is the field's own.
TEST_P(NormalsOnEveryGrid, OfAQuadraticFieldAreExactWhenCubic) {
  const auto volume = load(quadratic_volume(geometry(), kEllipsoid));
  const NormalErrors errors = normal_errors(
      volume, 0.0, [&](glm::dvec3 point_mm) { return kEllipsoid.gradient_per_mm(point_mm); }, true);
  EXPECT_GT(errors.looked_at, 3000);
  EXPECT_LE(errors.worst_degrees, 0.005);
}

TEST_P(NormalsOnEveryGrid, OfABallAreRadial) {
  const auto volume = load(sphere_volume(geometry(), 40.0));
  const NormalErrors errors =
      normal_errors(volume, 20.0, [](glm::dvec3 point_mm) { return -point_mm; });
  EXPECT_GT(errors.looked_at, 1500);
  // Third derivatives of the distance at 20 mm and one voxel's spacing allow 0.034 degrees; with
  // the square of the spacing, that is four times as much in the long direction, and a little of
  // the shorter one's.
  const bool is_isotropic = std::get<0>(GetParam()) == glm::dvec3(1.0);
  EXPECT_LE(errors.worst_degrees, (is_isotropic ? 0.034 : 0.16) + filter_error_degrees());
}

INSTANTIATE_TEST_SUITE_P(Normals, NormalsOnEveryGrid,
                         testing::Combine(testing::Values(glm::dvec3(1.0), kAnisotropicSpacingMm),
                                          testing::Values(glm::dmat3(1.0), oblique_direction(),
                                                          flipped_direction())));

TEST(Normals, AnAnisotropicGridGivesThePictureOfAnIsotropicOne) {
  const auto isotropic = load(sphere_volume(centred_geometry(96), 40.0));
  const auto anisotropic =
      load(sphere_volume(centred_geometry(glm::ivec3(96.0 / kAnisotropicSpacingMm),
                                          kAnisotropicSpacingMm, oblique_direction()),
                         40.0));
  const Scene scene = surface_scene(isotropic, 0.0);
  GpuHarness& gpu = GpuHarness::instance();
  const BytePicture one = gpu.render(scene, isotropic, settings_for(scene));
  const auto surface = FramePipeline::read_surface(gpu.view(), kContext);
  const BytePicture other = gpu.render(scene, anisotropic, settings_for(scene));
  const auto other_surface = FramePipeline::read_surface(gpu.view(), kContext);
  int compared = 0;
  int on_one_only = 0;
  int worst = 0;
  for (int i = 0; i < kNormalsViewport.width_px * kNormalsViewport.height_px; ++i) {
    const bool is_held = surface[i].w >= 0.0F;
    if (is_held != (other_surface[i].w >= 0.0F)) {
      ++on_one_only;  // rays that graze the ball
    } else if (is_held) {
      const glm::ivec2 pixel(i % kNormalsViewport.width_px, i / kNormalsViewport.width_px);
      const glm::ivec3 apart = glm::abs(one.rgb(pixel) - other.rgb(pixel));
      worst = std::max({worst, apart.r, apart.g, apart.b});
      ++compared;
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_LE(on_one_only, 10);
  EXPECT_GT(compared, 6000);
}

}  // namespace
}  // namespace cutaway::test
