// Lines from the brightness, on pictures with a known answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/filter_harness.h"
#include "support/reference_filters.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;

double cumulative(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

/// How much of the white picture has become black ink.
double ink_at(const BranchImage& before, const BranchImage& after, glm::ivec2 at) {
  return 1.0 - after.at(at).colour.r / before.at(at).colour.r;
}

Module black(const char* name, Json parameters) {
  parameters["colour"] = {0, 0, 0};
  return filter_module(name, parameters);
}

/// From the dark side on: tau (wide) - near of a step of height h at distance x from it.
double difference_at(double x, double dark, double height, double sigma, double tau) {
  const double near = dark + height * cumulative(x / sigma);
  const double wide = dark + height * cumulative(x / (1.6 * sigma));
  return tau * wide - near;
}

TEST(Dog, OfAStepIsItsClosedForm) {
  const auto step = grey({80, 60}, [](int x, int) { return representable(x < 40 ? 0.5 : 0.54); });
  for (const double sigma : {2.0, 4.0}) {
    const BranchImage drawn =
        filtered_on_gpu(step, black("dog", {{"sigma", sigma}, {"threshold", 0}}));
    for (int x = 22; x < 58; ++x) {
      const double dark = step.at({30, 30}).colour.r;
      const double height = step.at({50, 30}).colour.r - dark;
      const double expected =
          std::clamp(difference_at(x + 0.5 - 40.0, dark, height, sigma, 1.0) / 0.01, 0.0, 1.0);
      EXPECT_NEAR(ink_at(step, drawn, {x, 30}), expected, 0.03) << sigma << " " << x;
      if (x >= 41) {
        EXPECT_LT(ink_at(step, drawn, {x, 30}), 0.01) << "the light side";
      }
    }
  }
}

/// Of a disc: a closed curve about as long as its edge.
TEST(Dog, OfADiscIsAClosedRing) {
  const auto disc = grey({96, 96}, [](int x, int y) {
    return glm::distance(glm::dvec2(x, y), glm::dvec2(47.5)) < 30.0 ? 0.2 : 0.8;
  });
  const BranchImage drawn = filtered_on_gpu(disc, black("dog", {{"sigma", 1.5}}));
  for (int degrees = 0; degrees < 360; degrees += 3) {
    double most = 0.0;
    for (double radius = 24.0; radius < 30.0; radius += 0.5) {
      const double angle = glm::radians(double(degrees));
      const glm::ivec2 at(glm::dvec2(47.5) + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
      most = std::max(most, ink_at(disc, drawn, at));
    }
    EXPECT_GT(most, 0.9) << degrees;
  }
  EXPECT_LT(ink_at(disc, drawn, {47, 47}), 0.01);
  EXPECT_LT(ink_at(disc, drawn, {5, 47}), 0.01);
}

TEST(Xdog, WithoutEdgesIsAThresholdOfTheBlur) {
  const auto step = grey({60, 40}, [](int x, int) { return representable(x < 30 ? 0.2 : 0.8); });
  const BranchImage drawn = filtered_on_gpu(
      step, black("xdog", {{"sigma", 3}, {"edges", 0}, {"threshold", 0.5}, {"hardness", 8}}));
  for (int x = 12; x < 48; ++x) {
    const double blurred = 0.2 + 0.6 * cumulative((x + 0.5 - 30.0) / 3.0);
    EXPECT_NEAR(ink_at(step, drawn, {x, 20}), std::tanh(8.0 * std::max(0.5 - blurred, 0.0)), 0.02)
        << x;
  }
}

/// Of an edge under noise: ink in one row is joined to ink in the next.
double breaks(const BranchImage& before, const BranchImage& drawn) {
  int broken = 0;
  for (int y = 10; y < 70; ++y) {
    double most = 0.0;
    for (int x = 30; x < 50; ++x) most = std::max(most, ink_at(before, drawn, {x, y}));
    broken += most < 0.5 ? 1 : 0;
  }
  return broken;
}

TEST(Fdog, KeepsALineWholeWhereNoiseBreaksIt) {
  BranchImage noisy = random_picture(5, {80, 80});
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) {
      const double noise = noisy.at({x, y}).colour.r - 0.5;
      noisy.at({x, y}) = {glm::dvec3(representable((x < 40 ? 0.5 : 0.62) + 0.16 * noise)), 1.0,
                          1.0};
    }
  }
  const BranchImage plain =
      filtered_on_gpu(noisy, black("fdog", {{"sigma", 1.2}, {"length", 0}, {"hardness", 150}}));
  const BranchImage coherent =
      filtered_on_gpu(noisy, black("fdog", {{"sigma", 1.2}, {"length", 8}, {"hardness", 150}}));
  std::printf("breaks: %g along no way, %g along the flow\n", breaks(noisy, plain),
              breaks(noisy, coherent));
  EXPECT_LE(breaks(noisy, coherent), breaks(noisy, plain));
  double stray = 0.0;
  double stray_of_plain = 0.0;
  for (int y = 10; y < 70; ++y) {
    for (int x = 5; x < 25; ++x) {
      stray += ink_at(noisy, coherent, {x, y});
      stray_of_plain += ink_at(noisy, plain, {x, y});
    }
  }
  EXPECT_LT(stray, 0.6 * stray_of_plain) << "specks beside the line";
}

TEST(Canny, OfADiscIsAClosedCurveOfOnePixel) {
  constexpr double kRadius = 30.0;
  const auto disc = grey({96, 96}, [&](int x, int y) {
    const double from_edge = kRadius - glm::distance(glm::dvec2(x, y), glm::dvec2(47.3, 47.6));
    return representable(0.2 + 0.6 * std::clamp(from_edge + 0.5, 0.0, 1.0));
  });
  const BranchImage drawn = filtered_on_gpu(disc, black("canny", {{"high", 0.3}}));
  int pixels = 0;
  std::set<int> degrees;
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      if (ink_at(disc, drawn, {x, y}) < 0.5) continue;
      const glm::dvec2 from_middle = glm::dvec2(x, y) - glm::dvec2(47.3, 47.6);
      EXPECT_NEAR(glm::length(from_middle), kRadius, 1.2) << x << "," << y;
      degrees.insert(static_cast<int>(
          std::lround(glm::degrees(std::atan2(from_middle.y, from_middle.x)) / 3.0)));
      ++pixels;
    }
  }
  // A closed curve of pixels that touch at corners is between 8 r / sqrt 2 and 8 r long.
  EXPECT_GE(pixels, 8.0 * kRadius / std::sqrt(2.0) - 4);
  EXPECT_LE(pixels, 8.0 * kRadius);
  EXPECT_GE(degrees.size(), 120U);
}

/// The thresholds are heights of steps, whatever sigma is.
TEST(Canny, MeasuresStepsByTheirHeight) {
  for (const double sigma : {1.4, 3.0, 6.0}) {
    for (const double height : {0.2, 0.4}) {
      const auto step =
          grey({60, 40}, [&](int x, int) { return representable(x < 30 ? 0.4 : 0.4 + height); });
      const auto edges = [&](double high) {
        const BranchImage drawn =
            filtered_on_gpu(step, black("canny", {{"sigma", sigma}, {"high", high}, {"low", 1}}));
        int count = 0;
        for (int x = 0; x < 60; ++x) count += ink_at(step, drawn, {x, 20}) > 0.5 ? 1 : 0;
        return count;
      };
      EXPECT_EQ(edges(0.85 * height), 1) << sigma;
      EXPECT_EQ(edges(1.02 * height), 0) << sigma;
    }
  }
}

TEST(Canny, FollowsAWeakEdgeAsFarAsItsTrail) {
  // An edge that is strong at the top and ever weaker below.
  const auto edge =
      grey({40, 64}, [](int x, int y) { return representable(x < 20 ? 0.3 : 0.75 - 0.006 * y); });
  const auto drawn_to = [&](int trail) {
    const BranchImage drawn =
        filtered_on_gpu(edge, black("canny", {{"high", 0.3}, {"low", 0.1}, {"trail", trail}}));
    int last = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 17; x < 23; ++x)
        if (ink_at(edge, drawn, {x, y}) > 0.5) last = y;
    }
    return last;
  };
  EXPECT_NEAR(drawn_to(10) - drawn_to(0), 10, 1);
  EXPECT_NEAR(drawn_to(32) - drawn_to(0), 32, 1);
}

TEST(LuminanceQuantisation, GathersARampAboutItsLevels) {
  const auto ramp = grey({512, 3}, [](int x, int) { return x / 512.0; });
  for (const int bins : {2, 5, 16}) {
    const BranchImage drawn = filtered_on_gpu(
        ramp, filter_module("luminance_quantisation", {{"bins", bins}, {"hardness", 14}}));
    double last = -1.0;
    int near_a_level = 0;
    for (int x = 0; x < 512; ++x) {
      const double level = drawn.at({x, 1}).colour.r;
      EXPECT_GE(level, last - 1e-6);
      last = level;
      const double place = level * (bins - 1);
      near_a_level += std::abs(place - std::round(place)) < 0.05 ? 1 : 0;
    }
    EXPECT_GT(near_a_level, 300) << bins;
  }
}

TEST(LuminanceQuantisation, KeepsTheHue) {
  const BranchImage input = random_picture(8);
  const BranchImage drawn = filtered_on_gpu(input, filter_module("luminance_quantisation"));
  for (std::size_t i = 0; i < input.pixels.size(); ++i) {
    const glm::dvec3 before = input.pixels[i].colour;
    const glm::dvec3 after = drawn.pixels[i].colour;
    if (input.pixels[i].coverage == 0.0 || std::max({after.r, after.g, after.b}) > 0.99) continue;
    EXPECT_NEAR(after.r * before.g, after.g * before.r, 3e-3);
    EXPECT_NEAR(after.b * before.g, after.g * before.b, 3e-3);
  }
}

/// What draws lines of the brightness draws none along the lens' rim.
TEST(LineFilters, DrawNothingAlongTheLensRim) {
  auto input = grey({60, 40}, [](int x, int) { return x < 30 ? 0.25 : 0.75; });
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 60; ++x) {
      input.at({x, y}).normal = {0.0, -1.0, 0.0};
      input.at({x, y}).behind_lens = x < 30 ? 0.0 : 1.0;
    }
  }
  for (const char* name : {"dog", "fdog", "canny"}) {
    const BranchImage drawn = filtered_on_gpu(input, black(name, Json::object()));
    for (int x = 0; x < 60; ++x)
      EXPECT_NEAR(ink_at(input, drawn, {x, 20}), 0.0, 0.01) << name << " " << x;
  }
}

}  // namespace
}  // namespace cutaway::test
