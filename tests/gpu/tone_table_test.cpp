// The tone shader's table, through the shader itself: a plane has one normal, and the light's
// direction gives the lookup position.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/analytic_volumes.h"
#include "support/gpu_harness.h"

namespace cutaway::test {
namespace {

constexpr Viewport kTableViewport{16, 16};

/// Material behind the plane y = 0, which faces a viewer in front.
const std::shared_ptr<const LoadedVolume>& wall() {
  static const auto volume = load(
      quadratic_volume(centred_geometry(24), QuadraticField{.linear = glm::dvec3(0.0, 1.0, 0.0)}));
  return volume;
}

/// The wall's picture under light at the cosine `n.l`; every pixel is the same.
glm::ivec3 wall_colour(const Json& shading, double cosine) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const Scene scene = scene_for(
      {{"camera",
        {{"projection", "orthographic"},
         {"eye_mm", {0, -100, 0}},
         {"target_mm", {0, 0, 0}},
         {"up", {0, 0, 1}},
         {"view_height_mm", 8}}},
       {"context",
        {{"surface", {{"iso_value", 0}}}, {"shading", shading}, {"filters", Json::array()}}},
       {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}},
       {"light", {{"frame", "patient"}, {"direction", {sine, -cosine, 0.0}}}}},
      wall(), kTableViewport);
  const BytePicture picture = GpuHarness::instance().render(scene, wall(), settings_for(scene));
  return picture.rgb({8, 8});
}

/// Where in the ramp from black to white the shader is at a lookup position, 0..1.
double ramp_level(double ts, double u, const Json& more = Json::object()) {
  Json shading = {{"name", "tone"}, {"ts", ts}, {"dark", {0, 0, 0}}, {"light", {1, 1, 1}}};
  shading.update(more);
  return wall_colour(shading, 2.0 * u - 1.0).r / 255.0;
}

/// What a byte rounds by, and the half float that holds a branch's colour.
constexpr double kByte = 0.5 / 255.0 + 5e-4;

TEST(ToneTable, IsWhatTheShaderDraws) {
  struct Row {
    double ts;
    std::array<double, 6> v;
  };
  const std::array<Row, 4> table{Row{0.0, {0, 0, 0, 1, 1, 1}}, Row{0.1, {0, .05, .10, .90, .95, 1}},
                                 Row{0.25, {0, .125, .25, .75, .875, 1}},
                                 Row{0.5, {0, .25, .50, .50, .75, 1}}};
  const std::array<double, 6> u{0.0, 0.25, 0.5 - 1e-6, 0.5, 0.75, 1.0};
  for (const Row& row : table) {
    for (std::size_t i = 0; i < u.size(); ++i)
      EXPECT_NEAR(ramp_level(row.ts, u[i]), row.v[i], kByte) << row.ts << " at " << u[i];
  }
}

TEST(ToneTable, RisesAllTheWay) {
  for (const double ts : {0.0, 0.1, 0.25, 0.4, 0.5}) {
    double last = 0.0;
    for (int i = 0; i <= 40; ++i) {
      const double level = ramp_level(ts, i / 40.0);
      EXPECT_GE(level, last) << ts << " at " << i / 40.0;
      last = level;
    }
    EXPECT_EQ(last, 1.0);
  }
}

TEST(ToneTable, ATerminatorMovesTheMiddleOfTheRampAndLeavesItsEnds) {
  for (const double terminator : {-0.4, 0.3, 0.8}) {
    const Json more = {{"terminator", terminator}};
    const double u = 0.5 * (terminator + 1.0);
    EXPECT_NEAR(ramp_level(0.5, u, more), 0.5, kByte) << terminator;
    EXPECT_NEAR(ramp_level(0.5, 0.5 * u, more), 0.25, kByte) << terminator;
    EXPECT_NEAR(ramp_level(0.5, 0.5 * (u + 1.0), more), 0.75, kByte) << terminator;
    EXPECT_EQ(ramp_level(0.5, 0.0, more), 0.0);
    EXPECT_EQ(ramp_level(0.5, 1.0, more), 1.0);
  }
}

TEST(ToneTable, ClampedLambertIsFlatAwayFromTheLight) {
  const Json clamped = {{"lambert", "clamped"}};
  for (const double u : {0.0, 0.2, 0.45}) EXPECT_EQ(ramp_level(0.5, u, clamped), 0.0) << u;
  EXPECT_NEAR(ramp_level(0.5, 0.75, clamped), 0.5, kByte);  // 60 degrees
  EXPECT_EQ(ramp_level(0.5, 1.0, clamped), 1.0);
}

TEST(GoochFormula, IsReproducedAtThePolesAndBetween) {
  // Grey 0.6, b = y = 0.4, alpha = 0.2, beta = 0.6.
  const glm::dvec3 cool(0.12, 0.12, 0.52);
  const glm::dvec3 warm(0.76, 0.76, 0.36);
  for (const double cosine : {-1.0, -0.5, 0.0, 0.3, 1.0}) {
    const glm::ivec3 colour = wall_colour({{"name", "gooch"}}, cosine);
    const glm::dvec3 expected = glm::mix(cool, warm, 0.5 * (1.0 + cosine));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(colour[c] / 255.0, expected[c], kByte) << cosine;
  }
}

TEST(GoochFormula, IsTheToneShadersAtFullDetailByteForByte) {
  const Json tone = {
      {"name", "tone"}, {"detail", 1}, {"dark", {0.12, 0.12, 0.52}}, {"light", {0.76, 0.76, 0.36}}};
  int different = 0;
  for (int i = 0; i <= 200; ++i) {
    const double cosine = i / 100.0 - 1.0;
    different += wall_colour({{"name", "gooch"}}, cosine) == wall_colour(tone, cosine) ? 0 : 1;
  }
  EXPECT_EQ(different, 0);
}

}  // namespace
}  // namespace cutaway::test
