// Kuwahara by sectors on pictures with a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "support/filter_harness.h"
#include "support/reference_filters.h"
#include "support/reference_flow.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;
using reference::BranchPixel;

Module brush(const Json& parameters = Json::object()) {
  return filter_module("anisotropic_kuwahara", parameters);
}

/// Bright on one side of a line through the middle at that angle, anti-aliased, with noise.
BranchImage noisy_edge(double degrees, double noise, glm::ivec2 size = {48, 48}) {
  std::mt19937 random(7);
  std::normal_distribution<double> level(0.0, noise);
  const glm::dvec2 normal(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
  return grey(size, [&](int x, int y) {
    const double distance = glm::dot(glm::dvec2(x, y) - glm::dvec2(size - 1) / 2.0, normal);
    return representable(std::clamp(
        0.5 + 0.3 * std::clamp(2.0 * distance, -1.0, 1.0) + (noise > 0.0 ? level(random) : 0.0),
        0.0, 1.0));
  });
}

TEST(AnisotropicKuwahara, AConstantPictureStaysAsItIs) {
  for (const double radius : {1.0, 6.0, 15.0}) {
    for (const double level : {0.0, 0.375, 1.0}) {
      const BranchImage output = filtered_on_gpu(grey({40, 34}, [&](int, int) { return level; }),
                                                 brush({{"radius", radius}}));
      for (const BranchPixel& pixel : output.pixels) {
        ASSERT_NEAR(pixel.colour.r, level, 1e-3) << radius;
        ASSERT_EQ(pixel.coverage, 1.0);
      }
    }
  }
}

TEST(AnisotropicKuwahara, OfRadiusZeroChangesNothing) {
  const BranchImage input = random_picture(4);
  const BranchImage output = filtered_on_gpu(input, brush({{"radius", 0}}));
  for (std::size_t i = 0; i < input.pixels.size(); ++i) {
    if (input.pixels[i].coverage > 0.0) {
      ASSERT_EQ(output.pixels[i].colour, input.pixels[i].colour);
    }
  }
}

TEST(AnisotropicKuwahara, TheBackgroundNeitherBleedsInNorMoves) {
  auto input = grey({31, 31}, [](int, int) { return 0.5; });
  for (int y = 0; y < 31; ++y) {
    for (int x = 0; x < 12; ++x) input.at({x, y}) = {};
  }
  const BranchImage output = filtered_on_gpu(input, brush());
  for (int x = 0; x < 31; ++x) {
    EXPECT_EQ(output.at({x, 15}).coverage, x < 12 ? 0.0 : 1.0);
    if (x >= 12) {
      EXPECT_NEAR(output.at({x, 15}).colour.r, 0.5, 1e-3);
    }
  }
}

TEST(AnisotropicKuwahara, FollowsAnIdealEdgeAndNoNoise) {
  for (const double degrees : {0.0, 20.0, 45.0, 90.0, 130.0}) {
    const BranchImage edge = noisy_edge(degrees, 0.0);
    const auto flow = reference::flow_of(edge, reference::weighed_colours(edge), 2.0).at({24, 24});
    const glm::dvec2 along(-std::sin(glm::radians(degrees)), std::cos(glm::radians(degrees)));
    EXPECT_GT(std::abs(glm::dot(flow.along, along)), 0.999) << degrees;
    EXPECT_GT(flow.coherence, 0.99) << degrees;
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> level(0.0, 1.0);
  const BranchImage noise = grey({64, 64}, [&](int, int) { return level(random); });
  const auto flows = reference::flow_of(noise, reference::weighed_colours(noise), 8.0);
  double sum = 0.0;
  for (const auto& flow : flows.pixels) sum += flow.coherence;
  EXPECT_LT(sum / 4096.0, 0.15);
}

/// The generalised filter over every pixel of the disc, as its sources have it.
double generalised(const BranchImage& input, glm::ivec2 at, double radius, double sharpness) {
  double sum = 0.0;
  double all = 0.0;
  for (int i = 0; i < 8; ++i) {
    double weights = 0.0;
    double mean = 0.0;
    double squares = 0.0;
    for (int y = -20; y <= 20; ++y) {
      for (int x = -20; x <= 20; ++x) {
        const glm::dvec2 disc = glm::dvec2(x, y) / radius;
        if (glm::length(disc) > 1.0 || !input.contains(at + glm::ivec2(x, y))) continue;
        std::array<double, 8> sectors{};
        double share = 0.0;
        for (int k = 0; k < 8; ++k) {
          const double angle = k * std::numbers::pi / 4.0;
          const double u = std::cos(angle) * disc.x + std::sin(angle) * disc.y;
          const double v = std::cos(angle) * disc.y - std::sin(angle) * disc.x;
          sectors[k] = std::pow(std::max(0.0, u + 1.0 / 3.0 - 3.77 * v * v), 2.0);
          share += sectors[k];
        }
        const double weight = sectors[i] / share * std::exp(-3.125 * glm::dot(disc, disc));
        const double level = input.at(at + glm::ivec2(x, y)).colour.r;
        weights += weight;
        mean += weight * level;
        squares += weight * level * level;
      }
    }
    mean /= weights;
    const double deviation = std::sqrt(std::max(0.0, squares / weights - mean * mean));
    const double calm = 1.0 / (1.0 + std::pow(255.0 * 3.0 * deviation, sharpness));
    sum += calm * mean;
    all += calm;
  }
  return sum / all;
}

TEST(AnisotropicKuwahara, WithoutAnisotropyIsTheGeneralisedFilter) {
  for (const double degrees : {0.0, 30.0, 70.0}) {
    for (const double radius : {6.0, 12.0}) {
      const BranchImage input = noisy_edge(degrees, 0.01);
      const BranchImage output =
          filtered_on_gpu(input, brush({{"radius", radius}, {"anisotropy", 0}, {"sharpness", 4}}));
      double difference = 0.0;
      for (int y = 12; y < 36; ++y) {
        for (int x = 12; x < 36; ++x)
          difference +=
              std::abs(output.at({x, y}).colour.r - generalised(input, {x, y}, radius, 4.0)) /
              (24 * 24);
      }
      EXPECT_LE(difference, 3.0 / 255.0) << degrees << " " << radius;
    }
  }
}

double error_beside_edge(double degrees, const Module& filter) {
  const BranchImage ideal = noisy_edge(degrees, 0.0);
  const BranchImage output = filtered_on_gpu(noisy_edge(degrees, 0.08), filter);
  double squares = 0.0;
  int count = 0;
  for (int y = 10; y < 38; ++y) {
    for (int x = 10; x < 38; ++x) {
      const double error = output.at({x, y}).colour.r - ideal.at({x, y}).colour.r;
      squares += error * error;
      ++count;
    }
  }
  return std::sqrt(squares / count);
}

TEST(AnisotropicKuwahara, KeepsEdgesOfAnyAngleAlikeAndBetterThanKuwahara) {
  double best = 1.0;
  double worst = 0.0;
  double worst_of_kuwahara = 0.0;
  for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0}) {
    const double error = error_beside_edge(degrees, brush());
    best = std::min(best, error);
    worst = std::max(worst, error);
    worst_of_kuwahara = std::max(worst_of_kuwahara, error_beside_edge(degrees, kuwahara(4)));
  }
  std::printf("error beside an edge: %.4f to %.4f, Kuwahara's up to %.4f\n", best, worst,
              worst_of_kuwahara);
  EXPECT_LT(worst, 0.6 * worst_of_kuwahara);
  EXPECT_LT(worst, 2.5 * best);
}

TEST(AnisotropicKuwahara, OfATurnedPictureIsTheTurnedPicture) {
  const BranchImage input = noisy_edge(33.0, 0.05);
  const BranchImage one = turned(filtered_on_gpu(input, brush()));
  const BranchImage other = filtered_on_gpu(turned(input), brush());
  double difference = 0.0;
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    difference += std::abs(one.pixels[i].colour.r - other.pixels[i].colour.r);
  EXPECT_LE(difference / static_cast<double>(one.pixels.size()), 1.0 / 255.0);
}

}  // namespace
}  // namespace cutaway::test
