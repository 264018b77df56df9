// The Kuwahara filter on pictures with a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/analytic_volumes.h"
#include "support/filter_harness.h"
#include "support/gpu_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;
using reference::BranchPixel;

TEST(Kuwahara, AnIsolatedPixelIsSpreadOverItsQuadrantAndNowhereElse) {
  for (const int radius : {1, 2, 3, 5}) {
    const auto input = grey({31, 31}, [](int x, int y) { return x == 15 && y == 15 ? 1.0 : 0.0; });
    const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
    for (int y = 0; y < 31; ++y) {
      for (int x = 0; x < 31; ++x) {
        const double expected = x == 15 && y == 15 ? 1.0 / ((radius + 1) * (radius + 1)) : 0.0;
        EXPECT_NEAR(output.at({x, y}).colour.r, expected, 1e-3)
            << radius << " at " << x << "," << y;
      }
    }
  }
}

TEST(Kuwahara, ARampDoesNotShift) {
  for (const int radius : {1, 2, 5}) {
    const auto input = grey({41, 15}, [](int x, int) { return x / 64.0; });
    const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
    for (int x = radius; x < 41 - radius; ++x)
      EXPECT_NEAR(output.at({x, 7}).colour.r, x / 64.0, 1e-4) << radius;
  }
}

TEST(Kuwahara, StraightStepsAndCornersStayAsTheyAre) {
  const auto step = grey({21, 21}, [](int x, int) { return x < 10 ? 0.25 : 0.75; });
  const auto corner = grey({21, 21}, [](int x, int y) { return x < 10 && y < 10 ? 0.25 : 0.75; });
  for (const BranchImage& input : {step, corner}) {
    const BranchImage output = filtered_on_gpu(input, kuwahara(3));
    for (std::size_t i = 0; i < input.pixels.size(); ++i)
      EXPECT_NEAR(output.pixels[i].colour.r, input.pixels[i].colour.r, 1e-4);
  }
}

TEST(Kuwahara, TheBackgroundNeitherBleedsInNorMoves) {
  auto input = grey({21, 21}, [](int, int) { return 0.5; });
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 9; ++x) input.at({x, y}) = {};
  }
  const BranchImage output = filtered_on_gpu(input, kuwahara(4));
  for (int x = 0; x < 21; ++x) {
    EXPECT_EQ(output.at({x, 10}).coverage, x < 9 ? 0.0 : 1.0);
    if (x >= 9) {
      EXPECT_NEAR(output.at({x, 10}).colour.r, 0.5, 1e-4);
    }
  }
}

TEST(Kuwahara, AOnePixelLineIsSpreadAcrossItsWindowAndNowhereElse) {
  for (const int radius : {1, 2, 3, 5}) {
    for (const bool upright : {true, false}) {
      const auto input =
          grey({31, 31}, [&](int x, int y) { return (upright ? x : y) == 15 ? 1.0 : 0.0; });
      const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
      for (int y = 0; y < 31; ++y) {
        for (int x = 0; x < 31; ++x) {
          const double expected = (upright ? x : y) == 15 ? 1.0 / (radius + 1) : 0.0;
          EXPECT_NEAR(output.at({x, y}).colour.r, expected, 1e-4) << radius << " " << x << "," << y;
        }
      }
    }
  }
}

TEST(Kuwahara, AConstantPictureStaysAsItIs) {
  for (const int radius : {1, 4, 15}) {
    for (const double level : {0.0, 0.375, 1.0}) {
      const BranchImage output =
          filtered_on_gpu(grey({40, 34}, [&](int, int) { return level; }), kuwahara(radius));
      for (const BranchPixel& pixel : output.pixels) {
        ASSERT_NEAR(pixel.colour.r, level, 1e-6) << radius;
        ASSERT_EQ(pixel.coverage, 1.0);
      }
    }
  }
}

TEST(Kuwahara, StaysWithinWhatItsWindowHolds) {
  for (const int radius : {1, 3, 7}) {
    const BranchImage input = random_picture(11);
    const BranchImage output = filtered_on_gpu(input, kuwahara(radius));
    for (int y = 0; y < input.size_px.y; ++y) {
      for (int x = 0; x < input.size_px.x; ++x) {
        if (input.at({x, y}).coverage == 0.0) continue;
        glm::dvec3 least(1.0);
        glm::dvec3 most(0.0);
        for (int i = -radius; i <= radius; ++i) {
          for (int j = -radius; j <= radius; ++j) {
            const glm::ivec2 at(x + i, y + j);
            if (!input.contains(at) || input.at(at).coverage == 0.0) continue;
            least = glm::min(least, input.at(at).colour);
            most = glm::max(most, input.at(at).colour);
          }
        }
        const glm::dvec3 colour = output.at({x, y}).colour;
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(colour, least - 1e-6))) << x << "," << y;
        ASSERT_TRUE(glm::all(glm::lessThanEqual(colour, most + 1e-6))) << x << "," << y;
      }
    }
  }
}

TEST(Kuwahara, OfItsLargestRadiusIsTheReferences) {
  const BranchImage input = random_picture(3, {64, 56});
  const BranchImage actual = filtered_on_gpu(input, kuwahara(15));
  const BranchImage expected = reference::kuwahara(input, 15);
  for (std::size_t i = 0; i < input.pixels.size(); ++i) {
    if (input.pixels[i].coverage == 0.0) continue;
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(actual.pixels[i].colour[c], expected.pixels[i].colour[c], 1.0 / 255.0) << i;
  }
}

// In a view of its own, which has no sums from before.
TEST(Kuwahara, RadiusZeroChangesNothing) {
  GpuHarness& gpu = GpuHarness::instance();
  const auto volume = load(shells_volume(centred_geometry(32)));
  const auto picture = [&](const Json& filters) {
    const Scene scene = scene_for({{"context", {{"filters", filters}}}}, volume, {60, 40});
    return gpu.render(scene, volume, settings_for(scene)).rgba;
  };
  const auto plain = picture(Json::array());
  EXPECT_EQ(picture(Json::array({{{"name", "kuwahara"}, {"radius", 0}}})), plain);
  EXPECT_NE(picture(Json::array({{{"name", "kuwahara"}, {"radius", 4}}})), plain);
  EXPECT_EQ(picture(Json::array({{{"name", "kuwahara"}, {"radius", 0}}})), plain);
}

}  // namespace
}  // namespace cutaway::test
