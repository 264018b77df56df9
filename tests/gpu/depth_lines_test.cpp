// Lines along gaps in depth, on pictures and bodies with a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/analytic_volumes.h"
#include "support/filter_harness.h"
#include "support/gpu_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;

/// White, all covered, at the depth that is told.
BranchImage relief(glm::ivec2 size, const std::function<double(int, int)>& depth_mm) {
  BranchImage image = grey(size, [](int, int) { return 1.0; });
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      image.at({x, y}).depth_mm = image.at({x, y}).nearest_mm = depth_mm(x, y);
      image.at({x, y}).normal = {0.0, -1.0, 0.0};
    }
  }
  return image;
}

Module lines(const Json& parameters = Json::object()) {
  Json black = {{"colour", {0, 0, 0}}};
  black.update(parameters);
  return filter_module("depth_lines", black);
}

/// What is black of a row, px.
double ink_in_row(const BranchImage& picture, int y) {
  double sum = 0.0;
  for (int x = 0; x < picture.size_px.x; ++x) sum += 1.0 - picture.at({x, y}).colour.r;
  return sum;
}

TEST(DepthLines, GrowWithTheGapAndLieOnTheNearSide) {
  const std::pair<double, double> widths[] = {
      {1.0, 0.0}, {3.0, 1.15}, {11.0, 1.55}, {20.0, 2.0}, {200.0, 2.0}};
  for (const auto& [gap_mm, width_px] : widths) {
    const auto step = relief({40, 24}, [&](int x, int) { return x < 20 ? 300.0 : 300.0 + gap_mm; });
    const BranchImage drawn = filtered_on_gpu(step, lines());
    EXPECT_NEAR(ink_in_row(drawn, 12), width_px, 0.02) << gap_mm;
    for (int x = 20; x < 40; ++x) EXPECT_EQ(drawn.at({x, 12}).colour.r, 1.0) << gap_mm;
  }
}

TEST(DepthLines, HaveTheWidthThatIsAskedForAtAnyAngle) {
  for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
    const double angle = glm::radians(degrees);
    for (const double width : {3.0, 6.0}) {
      const auto step = relief({80, 80}, [&](int x, int y) {
        return std::cos(angle) * (x - 40) + std::sin(angle) * (y - 40) < 0.0 ? 300.0 : 400.0;
      });
      const BranchImage drawn = filtered_on_gpu(step, lines({{"width", width}}));
      double sum = 0.0;
      for (int y = 30; y < 50; ++y) sum += ink_in_row(drawn, y) * std::cos(angle) / 20.0;
      EXPECT_NEAR(sum, width, 0.5) << degrees;
    }
  }
}

TEST(DepthLines, AreNotDrawnOnSlopesHoweverSteep) {
  for (const double slope_mm : {0.5, 3.0, 10.0, 40.0}) {
    const auto plane =
        relief({40, 30}, [&](int x, int y) { return 300 + slope_mm * (x + 0.5 * y); });
    EXPECT_EQ(ink_in_row(filtered_on_gpu(plane, lines()), 12), 0.0) << slope_mm;
    const auto roof =
        relief({40, 30}, [&](int x, int) { return 300 + slope_mm * std::abs(x - 20); });
    EXPECT_EQ(ink_in_row(filtered_on_gpu(roof, lines()), 12), 0.0) << slope_mm;
  }
}

/// Steps of a slice of 3 mm on a surface that is seen aslant, as interpolation rounds them.
TEST(DepthLines, AreNotDrawnOnTheRingsOfSlices) {
  const auto rings = relief({60, 30}, [](int x, int) {
    const double slices = x / 6.0;
    const double part = slices - std::floor(slices);
    return 300.0 + 3.0 * (std::floor(slices) + part * part * (3.0 - 2.0 * part));
  });
  EXPECT_EQ(ink_in_row(filtered_on_gpu(rings, lines()), 12), 0.0);
}

/// Where a surface turns away, its rings are steps that hide what lies behind them.
TEST(DepthLines, AreNotDrawnOnAFlightOfLikeStepsButOnEachOfASparseOne) {
  const auto ink_of = [](int apart, double last_mm) {
    const auto stairs = relief({80, 30}, [&](int x, int) {
      const int step = std::min(x, 60) / apart;
      return 300.0 + 3.0 * step + (x > 64 ? last_mm : 0.0);
    });
    return ink_in_row(filtered_on_gpu(stairs, lines()), 12);
  };
  EXPECT_EQ(ink_of(3, 0.0), 0.0);
  EXPECT_NEAR(ink_of(3, 40.0), 2.0, 0.01) << "what lies behind the last of them";
  EXPECT_NEAR(ink_of(10, 0.0), 6 * 1.15, 0.1);
}

TEST(DepthLines, AreNoSpecks) {
  const auto specks = relief(
      {40, 30}, [](int x, int y) { return 300.0 + (x % 6 == 2 && y % 5 == 2 ? -10.0 : 0.0); });
  for (int y = 0; y < 30; ++y) EXPECT_EQ(ink_in_row(filtered_on_gpu(specks, lines()), y), 0.0);
}

TEST(DepthLines, AreDrawnAtSilhouettesButNotAtTheLensRim) {
  auto input = relief({30, 30}, [](int, int) { return 300.0; });
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 6; ++x) input.at({x, y}) = {};                             // background
    for (int x = 24; x < 30; ++x) input.at({x, y}) = {glm::dvec3(0.0), 0.0, 1.0};  // lens
  }
  const auto ink = [&](const Module& filter) {
    const BranchImage drawn = filtered_on_gpu(input, filter);
    double sum = 0.0;
    for (int x = 6; x < 24; ++x) sum += 1.0 - drawn.at({x, 15}).colour.r;
    return sum;
  };
  EXPECT_NEAR(ink(lines()), 2.0, 0.01);
  EXPECT_EQ(ink(lines({{"silhouettes", false}})), 0.0);
}

TEST(DepthLines, AreNotDrawnWhereTheLensBegins) {
  auto input = relief({30, 30}, [](int x, int) { return x < 15 ? 300.0 : 350.0; });
  for (int y = 0; y < 30; ++y) {
    for (int x = 15; x < 30; ++x) input.at({x, y}).behind_lens = 1.0;
  }
  EXPECT_EQ(ink_in_row(filtered_on_gpu(input, lines()), 15), 0.0);
}

/// The wall of a ball's cut falls away from its rim without bound.
TEST(DepthLines, AreNotDrawnWhereTheLensWallBegins) {
  auto input = relief({30, 30}, [](int x, int) {
    return x < 15 ? 300.0 : 300.0 + std::sqrt(2.0 * 60.0 * (x - 14));
  });
  for (int y = 0; y < 30; ++y) {
    for (int x = 15; x < 30; ++x) input.at({x, y}).behind_lens = 1.0;
  }
  EXPECT_EQ(ink_in_row(filtered_on_gpu(input, lines()), 15), 0.0);
}

TEST(DepthLines, OfStrengthOrWidthZeroChangeNothing) {
  const BranchImage input = random_picture(9);
  for (const Json& off : {Json{{"strength", 0}}, Json{{"width", 0}}}) {
    const BranchImage output = filtered_on_gpu(input, lines(off));
    for (std::size_t i = 0; i < input.pixels.size(); ++i) {
      if (input.pixels[i].coverage > 0.0) {
        ASSERT_EQ(output.pixels[i].colour, input.pixels[i].colour);
      }
    }
  }
}

/// Of two balls, one before the other: lines at both outlines and nowhere on them, at any light.
TEST(DepthLines, OfBodiesAreTheirOutlinesWhateverTheLight) {
  const auto volume = load(sampled_volume(centred_geometry(80), [](glm::dvec3 x) {
    return std::max(14.0 - glm::distance(x, glm::dvec3(-6.0, -20.0, 0.0)),
                    22.0 - glm::distance(x, glm::dvec3(6.0, 16.0, 4.0)));
  }));
  const auto scene = [&](const Json& light, int width_px) {
    return scene_for(
        {{"context",
          {{"surface", {{"iso_value", 0}}},
           {"shading", {{"name", "phong"}}},
           {"filters", {{{"name", "depth_lines"}, {"width", width_px}, {"colour", {1, 0, 0}}}}}}},
         {"focus", {{"surface", {{"iso_value", 100}}}}},
         {"camera", {{"eye_mm", {0, -300, 0}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}}},
         {"light", {{"direction", light}}},
         {"lens", {{"mode", "none"}, {"centre_mm", {0, 0, 0}}, {"radius_mm", 1}}}},
        volume, {160, 160});
  };
  const auto red = [&](const Scene& drawn, int supersampling) {
    RenderSettings settings = settings_for(drawn);
    settings.supersampling = supersampling;
    const BytePicture picture = GpuHarness::instance().render(drawn, volume, settings);
    std::vector<bool> pixels;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
      pixels.push_back(picture.rgba[i] > 200 && picture.rgba[i + 1] < 40);
    return pixels;
  };
  const auto from_left = red(scene({-0.7, 0.3, 0.6}, 2), 1);
  EXPECT_EQ(from_left, red(scene({0.7, -0.3, 0.6}, 2), 1));
  const auto count = std::ranges::count(from_left, true);
  EXPECT_GT(count, 250);
  EXPECT_LT(count, 900);
  RenderSettings settings = settings_for(scene({0, 0, 1}, 3));
  settings.supersampling = 2;
  expect_like_reference("depth-lines-rays", scene({0, 0, 1}, 3), volume, settings,
                        tolerance_for(scene({0, 0, 1}, 3)));
}

}  // namespace
}  // namespace cutaway::test
