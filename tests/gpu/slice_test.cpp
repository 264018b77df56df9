// Slices show the values of the points that they say they show, on every grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/slice_geometry.h"
#include "scene/view_geometry.h"
#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr double kWindowCentre = 100.0;
constexpr double kWindowWidth = 400.0;
/// Grey by rounding, and by a GPU's own filter, which weighs neighbours to 1/256.
constexpr double kTolerance = 1.6;

/// Linear in the position, so that linear interpolation is exact; larger to the patient's left, and
/// less so to posterior and superior.
double field_value(glm::dvec3 position_mm) {
  return kWindowCentre + glm::dot(position_mm, glm::dvec3(4.0, 2.0, 1.0));
}

Scene slice_scene(const std::shared_ptr<const LoadedVolume>& volume, ViewKind kind,
                  Json slices = Json::object()) {
  slices["window"] = {{"centre", kWindowCentre}, {"width", kWindowWidth}};
  return scene_for({{"slices", slices}, {"lens", {{"mode", "none"}}}}, volume, {120, 90, kind});
}

double expected_grey(double value) {
  return 255.0 * std::clamp((value - kWindowCentre) / kWindowWidth + 0.5, 0.0, 1.0);
}

bool is_inside(const VolumeGeometry& geometry, glm::dvec3 position_mm) {
  const glm::dvec3 index(patient_to_index(geometry) * glm::dvec4(position_mm, 1.0));
  return glm::all(glm::greaterThanEqual(index, glm::dvec3(0.0))) &&
         glm::all(glm::lessThanEqual(index, glm::dvec3(geometry.size_voxels - 1)));
}

struct SlicedGrid {
  glm::dvec3 spacing_mm;
  glm::dmat3 direction;
};

class Slices : public testing::TestWithParam<std::tuple<ViewKind, SlicedGrid>> {
 protected:
  std::shared_ptr<const LoadedVolume> volume() const {
    const auto [kind, grid] = GetParam();
    const VolumeGeometry geometry =
        centred_geometry(glm::ivec3(80.0 / grid.spacing_mm), grid.spacing_mm, grid.direction);
    return load(quadratic_volume(
        geometry, {.constant = kWindowCentre, .linear = {4.0, 2.0, 1.0}, .quadratic = {}}));
  }
};

/// Pixels in which the picture is not what it should be, and those that were looked at.
std::pair<int, int> wrong_pixels(const Scene& scene,
                                 const std::shared_ptr<const LoadedVolume>& volume) {
  const VolumeGeometry& geometry = volume->volume.geometry;
  const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
  const Camera camera = slice_camera(scene, half_axes_mm(geometry));
  int wrong = 0;
  int looked_at = 0;
  for (int y = 0; y < scene.viewport.height_px; ++y) {
    for (int x = 0; x < scene.viewport.width_px; ++x) {
      const glm::dvec3 at = ray_through(camera, scene.viewport, glm::dvec2(x, y) + 0.5).origin_mm;
      if (!is_inside(geometry, at)) continue;
      const double grey = picture.rgba[4 * (std::size_t(y) * scene.viewport.width_px + x)];
      wrong += std::abs(grey - expected_grey(field_value(at))) > kTolerance ? 1 : 0;
      ++looked_at;
    }
  }
  return {wrong, looked_at};
}

TEST_P(Slices, ShowTheValueOfEachPoint) {
  const Scene scene =
      slice_scene(volume(), std::get<0>(GetParam()), {{"crosshair_mm", {3.3, -7.1, 5.2}}});
  const auto [wrong, looked_at] = wrong_pixels(scene, volume());
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(looked_at, 2000);
}

TEST_P(Slices, OfATiltedCrosshairToo) {
  const Scene scene = slice_scene(volume(), std::get<0>(GetParam()),
                                  {{"superior", {0.3, -0.2, 0.9}},
                                   {"anterior", {0.2, -1, 0.1}},
                                   {"convention", "neurological"}});
  const auto [wrong, looked_at] = wrong_pixels(scene, volume());
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(looked_at, 2000);
}

INSTANTIATE_TEST_SUITE_P(
    EachPlaneAndGrid, Slices,
    testing::Combine(testing::Values(ViewKind::axial, ViewKind::coronal, ViewKind::sagittal),
                     testing::Values(SlicedGrid{glm::dvec3(1.0), glm::dmat3(1.0)},
                                     SlicedGrid{kAnisotropicSpacingMm, oblique_direction()},
                                     SlicedGrid{kAnisotropicSpacingMm, flipped_direction()})));

TEST(Slice, LeftIsAtTheRightForRadiologistsAndAtTheLeftForNeurologists) {
  const auto volume = load(quadratic_volume(
      centred_geometry(64), {.constant = kWindowCentre, .linear = {4, 0, 0}, .quadratic = {}}));
  for (const char* convention : {"radiological", "neurological"}) {
    const Scene scene = slice_scene(volume, ViewKind::axial, {{"convention", convention}});
    const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
    const auto red_at = [&](std::size_t x) {
      return picture.rgba[std::size_t{4} * (std::size_t{45} * 120 + x)];
    };
    const bool brighter_right = red_at(85) > red_at(35);
    EXPECT_EQ(brighter_right, std::string(convention) == "radiological");
  }
}

TEST(Slice, BesideTheVolumeThePictureIsBlack) {
  const auto volume = load(quadratic_volume(centred_geometry(32), {.constant = 1000.0}));
  const Scene scene = slice_scene(volume, ViewKind::coronal);
  const BytePicture picture = GpuHarness::instance().render(scene, volume, settings_for(scene));
  EXPECT_EQ(picture.rgba[0], 0);
  EXPECT_EQ(picture.rgba[std::size_t{4} * (45 * 120 + 60)], 255);
}

TEST(Slice, CostsNoRayAndIsDrawnOnce) {
  const auto volume = load(shells_volume(centred_geometry(32)));
  const Scene scene = slice_scene(volume, ViewKind::axial);
  GpuHarness& gpu = GpuHarness::instance();
  gpu.render(scene, volume, settings_for(scene));
  const StageCounts before = gpu.view().counts();
  Scene other = scene;
  other.camera.eye_mm += 10.0;
  gpu.render(other, volume, settings_for(other));
  EXPECT_EQ(gpu.view().counts(), before);
  other.slices.crosshair_mm.z += 3.0;
  gpu.render(other, volume, settings_for(other));
  EXPECT_EQ(gpu.view().counts().slice, before.slice + 1);
  EXPECT_EQ(gpu.view().counts().ray_cast, before.ray_cast);
}

}  // namespace
}  // namespace cutaway::test
