// The lens' bodies against what they are: closed forms, and each other's answers.
#include "scene/lenses/lens_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "scene/json_text.h"
#include "scene/resolve.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

class UnitBodies : public testing::TestWithParam<const char*> {
 protected:
  const UnitBody& body() const { return *find_lens_shape(GetParam()).body; }

  glm::dvec3 random(double reach) {
    std::uniform_real_distribution<double> each(-reach, reach);
    return {each(engine_), each(engine_), each(engine_)};
  }

 private:
  std::mt19937 engine_{20261129};
};

double volume_of(const std::string& shape) {
  if (shape == "box") return 8.0;
  if (shape == "cylinder") return 2.0 * glm::pi<double>();
  if (shape == "cone") return 2.0 * glm::pi<double>() / 3.0;
  return 4.0 * glm::pi<double>() / 3.0;
}

TEST_P(UnitBodies, FillTheirVolume) {
  constexpr int kPoints = 400'000;
  int inside = 0;
  for (int i = 0; i < kPoints; ++i) inside += body().gauge(random(1.0)) < 1.0 ? 1 : 0;
  EXPECT_NEAR(8.0 * inside / kPoints, volume_of(GetParam()), 0.01 * volume_of(GetParam()));
}

TEST_P(UnitBodies, RaysEnterAndLeaveOnTheSurface) {
  int crossed = 0;
  for (int i = 0; i < 20'000; ++i) {
    const glm::dvec3 direction = random(1.0);
    const glm::dvec3 anywhere = random(1.5);
    const glm::dvec3 foot =
        anywhere - glm::dot(anywhere, direction) / glm::dot(direction, direction) * direction;
    const glm::dvec2 interval = body().interval(foot, direction);
    if (interval.y <= interval.x) {
      EXPECT_EQ(interval, glm::dvec2(0.0));
      continue;
    }
    ++crossed;
    EXPECT_NEAR(body().gauge(foot + interval.x * direction), 1.0, 1e-5);
    EXPECT_NEAR(body().gauge(foot + interval.y * direction), 1.0, 1e-5);
    EXPECT_LT(body().offset(foot, direction), 1.0 + 1e-9);
    EXPECT_GE(body().rim(foot, direction, interval, 0.02), 0.0);
  }
  EXPECT_GT(crossed, 5'000);
}

TEST_P(UnitBodies, NoRayMissesWhatItPasses) {
  for (int i = 0; i < 20'000; ++i) {
    glm::dvec3 within = random(1.0);
    if (body().gauge(within) > 0.999) continue;
    const glm::dvec3 direction = random(1.0);
    const double foot_at = -glm::dot(within, direction) / glm::dot(direction, direction);
    const glm::dvec2 interval = body().interval(within + foot_at * direction, direction);
    EXPECT_LT(interval.x, -foot_at);
    EXPECT_GT(interval.y, -foot_at);
  }
}

TEST_P(UnitBodies, RaysAlongAxesAndMantlesAreNoSpecialCase) {
  for (const glm::dvec3 direction :
       {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.5, 0, 1),
        glm::dvec3(-0.5, 0, 1), glm::dvec3(0, 0.5, -1)}) {
    const glm::dvec2 interval = body().interval(glm::dvec3(0.0), direction);
    EXPECT_NEAR(body().gauge(interval.x * direction), 1.0, 1e-5) << direction.x;
    EXPECT_NEAR(body().gauge(interval.y * direction), 1.0, 1e-5) << direction.x;
    EXPECT_LT(interval.x, 0.0);
    EXPECT_GT(interval.y, 0.0);
  }
}

TEST_P(UnitBodies, NormalIsTheGaugesGradient) {
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 2'000; ++i) {
    const glm::dvec3 at = random(1.0);
    glm::dvec3 gradient(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0.0);
      step[axis] = kStep;
      gradient[axis] = (body().gauge(at + step) - body().gauge(at - step)) / (2.0 * kStep);
    }
    const double apart = glm::distance(gradient, body().normal(at));
    if (apart > 1e-3) {  // beside an edge the difference looks around the corner
      EXPECT_GT(
          glm::distance(body().normal(at), body().normal(at + 3e-6 * glm::dvec3(1, 1, 1))) +
              glm::distance(body().normal(at), body().normal(at - 3e-6 * glm::dvec3(1, -1, 1))),
          0.1);
    }
  }
}

TEST_P(UnitBodies, OutlineLiesOnTheSurfaceOfTheCube) {
  for (const glm::dvec2& corner : body().profile) {
    EXPECT_LE(std::abs(corner.y), 1.0 + 1e-12);
    EXPECT_NEAR(body().gauge({corner.x, 0.0, corner.y}), 1.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, UnitBodies, testing::Values("sphere", "box", "cylinder", "cone"),
                         [](const auto& shape) { return std::string(shape.param); });

Lens lens_of(const char* shape, double radius_mm = 20.0) {
  const Json document{
      {"lens",
       {{"centre_mm", {10, 20, 30}}, {"radius_mm", radius_mm}, {"shape", Json::parse(shape)}}}};
  return resolve_scene(document, ball_facts(), {100, 100}).lens;
}

TEST(LensBody, OfAnEllipsoidWithEqualSidesIsTheSphere) {
  const LensBody sphere(lens_of(R"({"name": "sphere"})"));
  const LensBody ellipsoid(lens_of(
      R"({"name": "ellipsoid", "width": 1, "height": 1, "depth": 1, "azimuth_degrees": 33})"));
  const ViewRay ray{{-100, 3, 41}, glm::normalize(glm::dvec3(1.0, 0.2, -0.1))};
  const auto a = sphere.interval_mm(ray);
  const auto b = ellipsoid.interval_mm(ray);
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(a->x, b->x, 1e-9);
  EXPECT_NEAR(a->y, b->y, 1e-9);
}

TEST(LensBody, PointsWhereItsAnglesSay) {
  const auto ahead = [](const char* shape) {
    return LensBody(lens_of(shape)).half_edges_mm()[2] / 20.0;
  };
  const auto expect_near = [](glm::dvec3 a, glm::dvec3 b) {
    EXPECT_LT(glm::distance(a, b), 1e-12);
  };
  expect_near(ahead(R"({"name": "cone"})"), {0, -1, 0});
  expect_near(ahead(R"({"name": "cone", "azimuth_degrees": 90})"), {1, 0, 0});
  expect_near(ahead(R"({"name": "cone", "elevation_degrees": 90})"), {0, 0, 1});
  expect_near(ahead(R"({"name": "cone", "length": 2})"), {0, -2, 0});
}

TEST(LensBody, HasItsWidthToTheLeftAndItsHeightToTheHead) {
  const LensBody body(lens_of(R"({"name": "box", "width": 2, "height": 0.5, "depth": 0.25})"));
  EXPECT_EQ(body.half_edges_mm()[0], glm::dvec3(40, 0, 0));
  EXPECT_EQ(body.half_edges_mm()[1], glm::dvec3(0, 0, 10));
  const auto across = body.interval_mm({{-90, 20, 30}, {1, 0, 0}});
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->x, 60.0, 1e-9);
  EXPECT_NEAR(across->y, 140.0, 1e-9);
  EXPECT_FALSE(body.interval_mm({{-90, 20, 41}, {1, 0, 0}}));
}

TEST(LensBody, ReachesAsFarAsItsFarthestPoint) {
  for (const char* shape :
       {R"({"name": "sphere"})", R"({"name": "ellipsoid", "azimuth_degrees": 40})",
        R"({"name": "box", "roll_degrees": 30, "width": 2})",
        R"({"name": "cylinder", "elevation_degrees": 20, "length": 3})",
        R"({"name": "cone", "azimuth_degrees": -70})"}) {
    const LensBody lens(lens_of(shape));
    const glm::dmat3 to_patient = glm::inverse(lens.body_from_patient());
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
    double farthest_mm = 0.0;
    for (int i = 0; i <= 60; ++i) {
      for (int k = 0; k < 120; ++k) {
        const double turn = glm::pi<double>() * k / 60.0;
        const double tilt = glm::pi<double>() * i / 60.0;
        const glm::dvec3 out(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                             std::cos(tilt));
        const glm::dvec3 on_surface = out / lens.body().gauge(out);
        farthest_mm = std::max(farthest_mm, std::abs(glm::dot(to_patient * on_surface, direction)));
      }
    }
    EXPECT_GE(lens.reach_mm(direction), farthest_mm) << shape;
    EXPECT_LE(lens.reach_mm(direction), 1.1 * farthest_mm) << shape;
  }
}

TEST(LensBody, OfNoSizeIsFinite) {
  const LensBody body(lens_of(R"({"name": "cylinder"})", 0.0));
  EXPECT_TRUE(std::isfinite(body.body_per_mm()));
}

}  // namespace
}  // namespace cutaway
