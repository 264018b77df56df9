#include "load/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "load/walk.h"

namespace cutaway::load {
namespace {

const Json kCamera = Json::parse(R"({"projection": "perspective", "eye_mm": [10, -600, 20],
    "target_mm": [10, 0, 20], "up": [0, 0, 2], "vertical_fov_degrees": 30})");
const CameraPath kPath(kCamera);
constexpr glm::dvec3 kTarget{10, 0, 20};

std::vector<Step> steps(const Motion& motion, double for_s, Pose pose = {}) {
  return steps_of({.for_s = for_s, .motion = motion}, {kPath, {200, 100}, 10.0}, pose);
}

glm::dvec3 eye_of(const Step& step) {
  const Json& eye = step.message.at("scene").at("camera").at("eye_mm");
  return {eye.at(0), eye.at(1), eye.at(2)};
}

double angle_degrees(const glm::dvec3& eye) {
  const glm::dvec3 home = glm::normalize(glm::dvec3(0, -600, 0));
  return std::acos(std::clamp(glm::dot(home, glm::normalize(eye - kTarget)), -1.0, 1.0)) * 180 /
         M_PI;
}

TEST(CameraPath, StartsAtHome) {
  EXPECT_NEAR(glm::distance(kPath.eye_mm({}), glm::dvec3(10, -600, 20)), 0.0, 1e-9);
}

TEST(CameraPath, RaisesTheEyeTowardsUp) {
  EXPECT_NEAR(kPath.eye_mm({.elevation_degrees = 30}).z, 20 + 300, 1e-6);
}

TEST(CameraPath, ZoomsAnOrthographicCameraByItsViewHeight) {
  Json camera = kCamera;
  camera["projection"] = "orthographic";
  camera["view_height_mm"] = 400;
  const Json message = CameraPath(camera).message({.distance = 0.5});
  EXPECT_DOUBLE_EQ(message.at("scene").at("camera").at("view_height_mm"), 200);
  EXPECT_DOUBLE_EQ(message.at("scene").at("camera").at("eye_mm").at(1), -600);
}

TEST(Motion, OrbitTurnsAtItsSpeedAndKeepsItsDistance) {
  const auto orbit = steps(Orbit{45.0}, 2.0);
  ASSERT_EQ(orbit.size(), 20U);
  EXPECT_DOUBLE_EQ(orbit[9].at_s, 1.0);
  EXPECT_NEAR(angle_degrees(eye_of(orbit[9])), 45.0, 1e-6);
  for (const Step& step : orbit) EXPECT_NEAR(glm::distance(eye_of(step), kTarget), 600.0, 1e-6);
}

TEST(Motion, OrbitGoesOnWhereItEnded) {
  Pose pose;
  const Stage stage{kPath, {200, 100}, 10.0};
  steps_of({.for_s = 2.0, .motion = Orbit{45.0}}, stage, pose);
  EXPECT_DOUBLE_EQ(pose.azimuth_degrees, 90.0);
}

TEST(Motion, InspectSwingsLittleAndPauses) {
  const auto inspect = steps(Inspect{.swing_degrees = 5, .move_s = 1, .pause_s = 1}, 4.0);
  EXPECT_NEAR(static_cast<double>(inspect.size()), 20.0, 3.0);
  for (const Step& step : inspect) {
    EXPECT_LE(std::fmod(step.at_s, 2.0), 1.0 + 1e-9);
    EXPECT_LE(angle_degrees(eye_of(step)), 6.0);
  }
}

TEST(Motion, DragGoesRoundItsCircle) {
  const auto drag =
      steps(DragLens{.centre = {0.25, 0.5}, .radius = 0.2, .turns_per_second = 0.25}, 4.0);
  ASSERT_EQ(drag.size(), 40U);
  for (const Step& step : drag) {
    EXPECT_EQ(step.message.at("type"), "drag_lens");
    const double x = step.message.at("position_px").at(0);
    const double y = step.message.at("position_px").at(1);
    EXPECT_NEAR(std::hypot(x - 50.0, y - 50.0), 20.0, 1e-9);
  }
  EXPECT_NEAR(drag[9].message.at("position_px").at(1), 70.0, 1e-9);  // a quarter turn, downwards
}

TEST(Motion, ZoomGoesToTheNearestAndBack) {
  const auto zoom = steps(Zoom{.nearest = 0.5, .period_s = 4.0}, 4.0);
  EXPECT_NEAR(glm::distance(eye_of(zoom[19]), kTarget), 300.0, 1e-6);
  EXPECT_NEAR(glm::distance(eye_of(zoom[39]), kTarget), 600.0, 1e-6);
}

TEST(Motion, RecordingsStartAgain) {
  const Recorded recorded{{{0.0, {{"type", "drag_lens"}}}, {0.4, {{"type", "scene"}}}}};
  const auto replayed = steps(recorded, 1.2);
  ASSERT_EQ(replayed.size(), 5U);
  EXPECT_DOUBLE_EQ(replayed[2].at_s, 0.5);
  EXPECT_EQ(replayed[3].message.at("type"), "scene");
}

TEST(Motion, IdleSendsNothing) { EXPECT_TRUE(steps(Idle{}, 5.0).empty()); }

Role walker() {
  return {.inputs_per_second = 10,
          .motion = {{.for_s = 1.0, .think_s = {0.5, 1.5}, .motion = Orbit{30}},
                     {.for_s = 2.0, .motion = Idle{}}}};
}

std::vector<double> times(const Role& role, std::uint32_t seed, double entry, int count) {
  Walk walk(role, kPath, seed, entry);
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(walk.next()->at_s);
  return result;
}

TEST(Walk, LoopsWithPausesBetween) {
  const Role role = walker();
  const std::vector<double> at = times(role, 1, 0.0, 20);
  EXPECT_TRUE(std::ranges::is_sorted(at));
  const double gap = at[10] - at[9];
  EXPECT_GE(gap, 2.0 + 0.5);
  EXPECT_LE(gap, 2.0 + 1.5 + 0.1 + 1e-9);
}

TEST(Walk, IsTheSameForTheSameSeed) {
  const Role role = walker();
  EXPECT_EQ(times(role, 7, 0.3, 50), times(role, 7, 0.3, 50));
  EXPECT_NE(times(role, 7, 0.3, 50), times(role, 8, 0.3, 50));
}

TEST(Walk, EntersTheLoopInTheMiddle) {
  const Role role = walker();
  EXPECT_GE(times(role, 1, 0.5, 1)[0], 0.5);
}

TEST(Walk, EndsWhereARoleNeverMoves) {
  const Role role{.motion = {{.for_s = 1.0, .motion = Idle{}}}};
  EXPECT_FALSE(Walk(role, kPath, 1, 0.0).next());
}

}  // namespace
}  // namespace cutaway::load
