// Sobel lines on pictures with a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "support/filter_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;

TEST(Sobel, RespondsWithTheKnownNumbers) {
  // Unit norm and a small step keep below the clamp: a step of 0.1 along an axis gives 4 * 0.1 / 4.
  const auto step = grey({12, 12}, [](int x, int) { return x < 6 ? 0.5 : 0.6; });
  const BranchImage edge = filtered_on_gpu(step, sobel(1.0, "brighten", "unit"));
  for (int x = 1; x < 11; ++x) {
    const double added = x == 5 || x == 6 ? 0.1 : 0.0;
    EXPECT_NEAR(edge.at({x, 6}).colour.r, (x < 6 ? 0.5 : 0.6) + added, 2e-3) << x;
  }
  const auto ramp = grey({12, 12}, [](int x, int) { return 0.2 + x / 256.0; });
  EXPECT_NEAR(filtered_on_gpu(ramp, sobel(1.0, "brighten")).at({6, 6}).colour.r,
              0.2 + 6 / 256.0 + 8 / 256.0, 2e-3);
}

TEST(Sobel, OfATurnedPictureIsTheTurnedPicture) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const auto input = grey({20, 14}, [&](int, int) { return representable(level(random)); });
  const BranchImage one = turned(filtered_on_gpu(input, sobel(0.7, "darken", "unit")));
  const BranchImage other = filtered_on_gpu(turned(input), sobel(0.7, "darken", "unit"));
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    EXPECT_NEAR(one.pixels[i].colour.r, other.pixels[i].colour.r, 1e-6);
}

TEST(Sobel, DarkAndBrightLinesAreEquallyFarFromThePicture) {
  const auto input = grey({16, 16}, [](int x, int y) { return 0.5 + 0.02 * ((x * y) % 3); });
  const BranchImage dark = filtered_on_gpu(input, sobel(0.7, "darken", "unit"));
  const BranchImage bright = filtered_on_gpu(input, sobel(0.7, "brighten", "unit"));
  for (std::size_t i = 0; i < input.pixels.size(); ++i) {
    const double mean = 0.5 * (dark.pixels[i].colour.r + bright.pixels[i].colour.r);
    EXPECT_NEAR(mean, input.pixels[i].colour.r, 1e-3);
  }
}

TEST(Sobel, StrengthZeroChangesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const auto input = grey({16, 16}, [&](int, int) { return representable(level(random)); });
  const BranchImage output = filtered_on_gpu(input, sobel(0.0, "darken"));
  for (std::size_t i = 0; i < input.pixels.size(); ++i)
    EXPECT_EQ(output.pixels[i].colour, input.pixels[i].colour);
}

TEST(Sobel, DrawsTheSilhouetteButNotTheLensRim) {
  auto input = grey({20, 20}, [](int, int) { return 0.5; });
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 5; ++x) input.at({x, y}) = {};  // background
    for (int x = 15; x < 20; ++x)
      input.at({x, y}) = {glm::dvec3(0.0), 0.0, 1.0};  // taken by the lens
  }
  const BranchImage output = filtered_on_gpu(input, sobel(1.0, "darken"));
  EXPECT_NEAR(output.at({5, 10}).colour.r, 0.0, 1e-3);
  EXPECT_NEAR(output.at({10, 10}).colour.r, 0.5, 1e-3);
  EXPECT_NEAR(output.at({14, 10}).colour.r, 0.5, 1e-3);
}

/// Sobel's two kernels as they stand in every textbook, applied to one channel; the picture's edge
/// is repeated. Shares no code with the reference.
struct Responses {
  double across = 0.0;
  double down = 0.0;
  double l1() const { return std::abs(across) + std::abs(down); }
  double l2() const { return std::sqrt(across * across + down * down); }
};

Responses convolved(const BranchImage& image, glm::ivec2 centre) {
  constexpr double kAcross[3][3] = {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
  constexpr double kDown[3][3] = {{-1, -2, -1}, {0, 0, 0}, {1, 2, 1}};
  Responses responses;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double level = image.clamped(centre + glm::ivec2(column - 1, row - 1)).colour.r;
      responses.across += kAcross[row][column] * level;
      responses.down += kDown[row][column] * level;
    }
  }
  return responses;
}

/// What is added to a picture so faint that neither a response nor the sum reaches one.
double response_on_gpu(const BranchImage& faint, glm::ivec2 at, const char* gradient) {
  const BranchImage output = filtered_on_gpu(faint, sobel(1.0, "brighten", "raw", gradient));
  return output.at(at).colour.r - faint.at(at).colour.r;
}

constexpr double kFaint = 1.0 / 16.0;

TEST(Sobel, OfASlantedStepIsTwoSixSixTwo) {
  // The step runs through pixel corners: rows from one side to the other cross it at 45 degrees.
  const auto step = grey({16, 16}, [](int x, int y) { return x + y >= 16 ? kFaint : 0.0; });
  const BranchImage lines = filtered_on_gpu(step, sobel(1.0, "brighten"));
  const std::array<double, 6> profile{0, 2, 6, 6, 2, 0};
  for (int i = 0; i < 6; ++i) {
    const glm::ivec2 at(5 + i, 8);  // the step is between x = 7 and 8
    EXPECT_NEAR(lines.at(at).colour.r - step.at(at).colour.r, profile[i] * kFaint, 1e-6) << i;
  }
}

TEST(Sobel, OfALonePixelIsTwoAllRoundAndNothingInTheMiddle) {
  const auto lone = grey({9, 9}, [](int x, int y) { return x == 4 && y == 4 ? kFaint : 0.0; });
  const BranchImage lines = filtered_on_gpu(lone, sobel(1.0, "brighten"));
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 9; ++x) {
      const int away = std::max(std::abs(x - 4), std::abs(y - 4));
      const double added = lines.at({x, y}).colour.r - lone.at({x, y}).colour.r;
      EXPECT_NEAR(added, away == 1 ? 2.0 * kFaint : 0.0, 1e-6) << x << "," << y;
    }
  }
}

TEST(Sobel, HasItsKnownMaxima) {
  // Of all patches of black and white, which hold the extremes of both lengths.
  double most_l1 = 0.0;
  double most_l2 = 0.0;
  constexpr int kPatches = 512;
  const auto bit = [](int patch, int x, int y) { return (patch >> (3 * y + x)) & 1; };
  // All in one picture: the middle of each sees nothing of its neighbours.
  const auto patches =
      grey({kPatches * 3, 3}, [&](int x, int y) { return bit(x / 3, x % 3, y) * kFaint; });
  const BranchImage l1 = filtered_on_gpu(patches, sobel(1.0, "brighten", "raw", "l1"));
  const BranchImage l2 = filtered_on_gpu(patches, sobel(1.0, "brighten", "raw", "l2"));
  for (int patch = 0; patch < kPatches; ++patch) {
    const glm::ivec2 middle(3 * patch + 1, 1);
    const double level = patches.at(middle).colour.r;
    most_l1 = std::max(most_l1, l1.at(middle).colour.r - level);
    most_l2 = std::max(most_l2, l2.at(middle).colour.r - level);
  }
  EXPECT_NEAR(most_l1, 6.0 * kFaint, 1e-6);
  EXPECT_NEAR(most_l2, std::sqrt(20.0) * kFaint, 1e-6);
}

TEST(Sobel, OfASlantedEdgeIsStrongerInL1AndNearlyEvenInL2) {
  const auto straight = grey({16, 16}, [](int x, int) { return x >= 8 ? kFaint : 0.0; });
  const auto slanted = grey({16, 16}, [](int x, int y) { return x + y >= 16 ? kFaint : 0.0; });
  const auto ratio = [&](const char* gradient) {
    return response_on_gpu(slanted, {8, 8}, gradient) / response_on_gpu(straight, {8, 8}, gradient);
  };
  EXPECT_NEAR(ratio("l1"), 1.5, 1e-4);
  EXPECT_NEAR(ratio("l2"), 3.0 * std::sqrt(2.0) / 4.0, 1e-4);
}

TEST(Sobel, IsTheTextbooksConvolution) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const auto input = grey({24, 18}, [&](int, int) { return representable(0.15 * level(random)); });
  for (const char* gradient : {"l1", "l2"}) {
    const BranchImage output = filtered_on_gpu(input, sobel(1.0, "brighten", "raw", gradient));
    for (int y = 0; y < 18; ++y) {
      for (int x = 0; x < 24; ++x) {
        const Responses responses = convolved(input, {x, y});
        const double length = gradient[1] == '1' ? responses.l1() : responses.l2();
        const double expected = std::min(1.0, input.at({x, y}).colour.r + std::min(1.0, length));
        EXPECT_NEAR(output.at({x, y}).colour.r, expected, 1e-5) << x << "," << y;
      }
    }
  }
}

}  // namespace
}  // namespace cutaway::test
