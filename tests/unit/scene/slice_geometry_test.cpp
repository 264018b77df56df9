// Left is left, in each slice and convention.
#include "scene/slice_geometry.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/resolve.h"
#include "scene/view_geometry.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

constexpr glm::dvec3 kLeft{1.0, 0.0, 0.0};
constexpr glm::dvec3 kPosterior{0.0, 1.0, 0.0};
constexpr glm::dvec3 kSuperior{0.0, 0.0, 1.0};

Scene slice_scene(ViewKind kind, const Json& slices = Json::object()) {
  Scene scene = resolve_scene({{"slices", slices}}, ball_facts(), {640, 480});
  scene.viewport = {200, 100, kind};
  return scene;
}

Camera camera_of(const Scene& scene) { return slice_camera(scene, ball_facts().grid_half_axes_mm); }

/// The patient point in the middle of a pixel's upper left corner.
glm::dvec3 point_at(const Scene& scene, glm::dvec2 position_px) {
  return ray_through(camera_of(scene), scene.viewport, position_px).origin_mm;
}

void expect_near(glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::distance(a, b), 1e-9); }

struct Side {
  ViewKind kind;
  const char* convention;
  glm::dvec3 right;
  glm::dvec3 up;
};

class SliceSides : public testing::TestWithParam<Side> {};

TEST_P(SliceSides, AreWhereReadersExpectThem) {
  const Side& side = GetParam();
  const CameraAxes axes =
      camera_axes(camera_of(slice_scene(side.kind, {{"convention", side.convention}})));
  expect_near(axes.right, side.right);
  expect_near(axes.up, side.up);
}

INSTANTIATE_TEST_SUITE_P(
    Slices, SliceSides,
    testing::Values(Side{ViewKind::axial, "radiological", kLeft, -kPosterior},
                    Side{ViewKind::coronal, "radiological", kLeft, kSuperior},
                    Side{ViewKind::sagittal, "radiological", kPosterior, kSuperior},
                    Side{ViewKind::axial, "neurological", -kLeft, -kPosterior},
                    Side{ViewKind::coronal, "neurological", -kLeft, kSuperior},
                    Side{ViewKind::sagittal, "neurological", kPosterior, kSuperior}));

TEST(SliceGeometry, ThePlaneGoesThroughTheCrosshairAndItsMiddleStaysInPlace) {
  const Scene scene =
      slice_scene(ViewKind::axial, {{"crosshair_mm", {5, 6, 70}},
                                    {"axial", {{"centre_mm", {1, 2, 3}}, {"view_height_mm", 50}}}});
  expect_near(point_at(scene, {100, 50}), {1, 2, 70});
  expect_near(point_at(scene, {100, 100}), {1, 27, 70});
  expect_near(point_at(scene, {200, 50}), {51, 2, 70});
}

TEST(SliceGeometry, BeginsOnAVoxelWithTheWholeVolumeInTheMiddle) {
  const Scene scene = slice_scene(ViewKind::axial);
  expect_near(scene.slices.crosshair_mm, ball_facts().middle_voxel_mm);
  expect_near(scene.slices.axial.centre_mm, ball_facts().grid_centre_mm);
}

TEST(SliceGeometry, ShowsTheWholeVolumeUnlessItIsToldOtherwise) {
  // 200 x 160 mm in a viewport of 2:1: the height decides, with 2 % to spare.
  EXPECT_NEAR(camera_of(slice_scene(ViewKind::axial)).view_height_mm, 1.02 * 180.0, 1e-9);
  Scene narrow = slice_scene(ViewKind::axial);
  narrow.viewport = {100, 200, ViewKind::axial};
  EXPECT_NEAR(camera_of(narrow).view_height_mm, 1.02 * 400.0, 1e-9);
}

TEST(SliceGeometry, ATiltedCrosshairTiltsEachPlane) {
  const Json slices{{"superior", {0, 1, 1}}, {"anterior", {0, -1, 0.5}}};
  const double half = std::sqrt(0.5);
  const CameraAxes axial = camera_axes(camera_of(slice_scene(ViewKind::axial, slices)));
  expect_near(axial.backward, {0, -half, -half});
  expect_near(axial.up, {0, -half, half});
  const CameraAxes sagittal = camera_axes(camera_of(slice_scene(ViewKind::sagittal, slices)));
  expect_near(sagittal.backward, kLeft);
}

TEST(SliceGeometry, TheSamePictureIsKnownForWhatItIs) {
  const Scene axial = slice_scene(ViewKind::axial);
  EXPECT_TRUE(show_the_same(axial, axial));
  Scene moved = axial;
  moved.slices.crosshair_mm += glm::dvec3(0.1, -17.3, 0.0);
  EXPECT_TRUE(show_the_same(axial, moved)) << "within the plane";
  moved.slices.crosshair_mm.z += 0.01;
  EXPECT_FALSE(show_the_same(axial, moved));
  Scene recoloured = axial;
  recoloured.lens.radius_mm += 1.0;
  EXPECT_TRUE(show_the_same(axial, recoloured)) << "a slice shows no lens";
  recoloured.slices.window.width += 1.0;
  EXPECT_FALSE(show_the_same(axial, recoloured));
}

TEST(SliceGeometry, TheVolumesPictureDependsOnNoSlice) {
  Scene scene = slice_scene(ViewKind::axial);
  scene.viewport = {640, 480};
  Scene other = scene;
  other.slices.crosshair_mm += 1.0;
  EXPECT_TRUE(show_the_same(scene, other));
  other.camera.eye_mm += 1.0;
  EXPECT_FALSE(show_the_same(scene, other));
}

TEST(SliceGeometry, AnotherVolumeHasSlicesOfItsOwn) {
  const Json document = scene_document(
      slice_scene(ViewKind::axial, {{"crosshair_mm", {5, 6, 70}}, {"convention", "neurological"}}));
  const Json left = without_volume_choices(document);
  EXPECT_EQ(left.at("slices"), Json::parse(R"({"convention": "neurological"})"));
}

}  // namespace
}  // namespace cutaway
