#include "scene/view_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cutaway {
namespace {

constexpr Viewport kViewport{640, 360};

Camera front_camera() {
  Camera camera;
  camera.eye_mm = {0, -500, 0};
  camera.target_mm = {0, 0, 0};
  camera.up = {0, 0, 1};
  camera.vertical_fov_degrees = 30.0;
  return camera;
}

/// NaN, which fails every comparison, where nothing appears.
glm::dvec2 pixel_of(const Camera& camera, glm::dvec3 point_mm) {
  return project_px(camera, kViewport, point_mm).value_or(glm::dvec2(NAN));
}

Camera random_camera(std::mt19937& generator) {
  std::uniform_real_distribution<double> any(-300.0, 300.0);
  const auto vector = [&] { return glm::dvec3(any(generator), any(generator), any(generator)); };
  Camera camera;
  camera.projection = generator() % 2 == 0 ? Projection::perspective : Projection::orthographic;
  camera.eye_mm = vector();
  camera.target_mm = vector();
  camera.up = vector();
  camera.vertical_fov_degrees = 1.0 + 0.35 * (any(generator) + 300.0) / 2.0;
  camera.view_height_mm = 310.0 + any(generator);
  return camera;
}

TEST(ViewGeometry, PatientsLeftIsOnThePicturesRightFromTheFront) {
  const Camera camera = front_camera();
  EXPECT_GT(pixel_of(camera, {50, 0, 0}).x, kViewport.width_px / 2.0);
  EXPECT_LT(pixel_of(camera, {0, 0, 50}).y, kViewport.height_px / 2.0);
}

TEST(ViewGeometry, AxesAreOrthonormalAndRightHanded) {
  std::mt19937 generator(7);
  for (int i = 0; i < 100; ++i) {
    const CameraAxes axes = camera_axes(random_camera(generator));
    EXPECT_NEAR(glm::length(axes.right), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(axes.right, axes.up), 0.0, 1e-12);
    EXPECT_LT(glm::distance(glm::cross(axes.right, axes.up), axes.backward), 1e-12);
  }
}

TEST(ViewGeometry, APointOnARayAppearsAtTheRaysPixel) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> fraction(-0.5, 1.5);
  for (int i = 0; i < 500; ++i) {
    const Camera camera = random_camera(generator);
    const glm::dvec2 pixel{fraction(generator) * kViewport.width_px,
                           fraction(generator) * kViewport.height_px};
    const ViewRay ray = ray_through(camera, kViewport, pixel);
    EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
    const glm::dvec2 again = pixel_of(camera, ray.origin_mm + 123.0 * ray.direction);
    EXPECT_LT(glm::distance(again, pixel), 1e-6);
  }
}

TEST(ViewGeometry, TheUpperEdgeIsHalfTheFieldOfViewAway) {
  const ViewRay ray = ray_through(front_camera(), kViewport, {320.0, 0.0});
  EXPECT_NEAR(std::atan2(ray.direction.z, ray.direction.y), glm::radians(15.0), 1e-12);
  Camera orthographic = front_camera();
  orthographic.projection = Projection::orthographic;
  orthographic.view_height_mm = 200.0;
  const glm::dvec3 origin = ray_through(orthographic, kViewport, {320.0, 0.0}).origin_mm;
  EXPECT_LT(glm::distance(origin, glm::dvec3(0, -500, 100)), 1e-9);
}

TEST(ViewGeometry, BehindTheEyeNothingAppears) {
  EXPECT_FALSE(project_px(front_camera(), kViewport, {0, -501, 0}));
  EXPECT_FALSE(project_px(front_camera(), kViewport, {0, -500, 0}));
}

TEST(ViewGeometry, PixelSizeIsTheDistanceOfNeighbouringPixels) {
  const Camera camera = front_camera();
  const double size_mm = pixel_size_mm(camera, kViewport, {30, 100, 20});
  const glm::dvec2 one = pixel_of(camera, {30, 100, 20});
  const glm::dvec2 other = pixel_of(camera, {30, 100, 20 + size_mm});
  EXPECT_NEAR(one.y - other.y, 1.0, 1e-9);
  EXPECT_NEAR(size_mm, 2.0 * 600.0 * std::tan(glm::radians(15.0)) / 360.0, 1e-12);
}

TEST(ViewGeometry, LightTurnsWithTheCameraOrStaysWithThePatient) {
  const Camera camera = front_camera();
  const Light headlight{LightFrame::camera, {0, 0, 3}};
  EXPECT_LT(glm::distance(light_direction_patient(headlight, camera), glm::dvec3(0, -1, 0)), 1e-12);
  const Light from_right{LightFrame::camera, {2, 0, 0}};
  EXPECT_LT(glm::distance(light_direction_patient(from_right, camera), glm::dvec3(1, 0, 0)), 1e-12);
  const Light fixed{LightFrame::patient, {0, 0, 5}};
  EXPECT_LT(glm::distance(light_direction_patient(fixed, camera), glm::dvec3(0, 0, 1)), 1e-12);
}

}  // namespace
}  // namespace cutaway
