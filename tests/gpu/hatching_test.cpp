// Pen and ink on pictures whose tone and curvature are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/filter_harness.h"

namespace cutaway::test {
namespace {

using reference::BranchImage;
using reference::BranchPixel;

constexpr const char* kDirections[] = {"curvature", "parallel"};

/// White paper, black ink.
Module hatching(Json parameters) {
  parameters["ink"] = {0, 0, 0};
  parameters["paper"] = {1, 1, 1};
  return filter_module("hatching", parameters);
}

double ink_at(const BranchImage& drawn, glm::ivec2 at) { return 1.0 - drawn.at(at).colour.r; }

/// `normal` of each pixel, seen from above.
template <typename Normal>
BranchImage surface(glm::ivec2 size, double level, Normal&& normal) {
  BranchImage image = grey(size, [&](int, int) { return representable(level); });
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      BranchPixel& pixel = image.at({x, y});
      pixel.normal = pixel.seen_normal = glm::normalize(normal(glm::dvec2(x, y) + 0.5));
    }
  }
  return image;
}

BranchImage flat(glm::ivec2 size, double level) {
  return surface(size, level, [](glm::dvec2) { return glm::dvec3(0.0, 0.0, 1.0); });
}

double mean_ink(const BranchImage& drawn, glm::ivec2 begin, glm::ivec2 end) {
  double sum = 0.0;
  for (int y = begin.y; y < end.y; ++y) {
    for (int x = begin.x; x < end.x; ++x) sum += ink_at(drawn, {x, y});
  }
  return sum / ((end.x - begin.x) * (end.y - begin.y));
}

/// How ink changes within a window: the products of its slopes to the right and up.
glm::dvec3 ink_tensor(const BranchImage& drawn, glm::ivec2 begin, glm::ivec2 end) {
  glm::dvec3 tensor(0.0);
  for (int y = begin.y; y < end.y; ++y) {
    for (int x = begin.x; x < end.x; ++x) {
      const auto ink = [&](int dx, int dy) { return ink_at(drawn, {x + dx, y + dy}); };
      double right = 0.0;
      double up = 0.0;
      for (const int i : {-1, 0, 1}) {
        // Scharr's weights, which turn with the picture better than Sobel's.
        const double weight = i == 0 ? 10.0 : 3.0;
        right += weight * (ink(1, i) - ink(-1, i));
        up += weight * (ink(i, -1) - ink(i, 1));
      }
      tensor += glm::dvec3(right * right, right * up, up * up);
    }
  }
  return tensor;
}

/// Towards which strokes run, in degrees: across the way in which ink changes most.
double stroke_degrees(const BranchImage& drawn, glm::ivec2 begin, glm::ivec2 end) {
  const glm::dvec3 t = ink_tensor(drawn, begin, end);
  return glm::degrees(0.5 * std::atan2(2.0 * t.y, t.x - t.z)) + 90.0;
}

/// 1: all strokes run one way; of two families that cross at an angle of a, |cos a|.
double agreement(const BranchImage& drawn, glm::ivec2 begin, glm::ivec2 end) {
  const glm::dvec3 t = ink_tensor(drawn, begin, end);
  return std::hypot(t.x - t.z, 2.0 * t.y) / (t.x + t.z);
}

/// Between two lines, 0..90.
double between_degrees(double one, double other) {
  const double apart = std::fmod(std::abs(one - other), 180.0);
  return std::min(apart, 180.0 - apart);
}

TEST(Hatching, CoversAsMuchAsThePictureIsDark) {
  for (const char* direction : kDirections) {
    for (const double width : {0.8, 1.5, 3.0}) {
      for (const double darkness : {0.05, 0.15, 0.35, 0.5, 0.65, 0.8, 0.95}) {
        const BranchImage drawn =
            filtered_on_gpu(flat({360, 360}, 1.0 - darkness),
                            hatching({{"direction", direction}, {"width", width}}));
        EXPECT_NEAR(mean_ink(drawn, {0, 0}, {360, 360}), darkness, 0.03)
            << direction << " " << width;
      }
    }
  }
}

TEST(Hatching, OfARampGetsDarkerAlongIt) {
  for (const char* direction : kDirections) {
    BranchImage ramp = flat({512, 200}, 1.0);
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 512; ++x)
        ramp.at({x, y}).colour = glm::dvec3(representable(1.0 - (x + 0.5) / 512.0));
    }
    const BranchImage drawn = filtered_on_gpu(ramp, hatching({{"direction", direction}}));
    double before = -1.0;
    for (int x = 0; x < 512; x += 64) {
      const double ink = mean_ink(drawn, {x, 0}, {x + 64, 200});
      EXPECT_NEAR(ink, (x + 32) / 512.0, 0.04) << direction;
      EXPECT_GT(ink, before);
      before = ink;
    }
  }
}

TEST(Hatching, LeavesWhiteWhiteAndFillsBlack) {
  for (const char* direction : kDirections) {
    for (const double level : {0.0, 1.0}) {
      const BranchImage drawn =
          filtered_on_gpu(flat({80, 60}, level), hatching({{"direction", direction}}));
      for (const BranchPixel& pixel : drawn.pixels)
        ASSERT_NEAR(pixel.colour.r, level, 1e-6) << direction;
    }
  }
}

/// So strokes neither move nor flicker when light changes: they grow.
TEST(Hatching, OfADarkerPictureHoldsThatOfALighterOne) {
  for (const char* direction : kDirections) {
    const Module module = hatching({{"direction", direction}});
    BranchImage before = filtered_on_gpu(flat({120, 90}, 0.98), module);
    for (const double level : {0.8, 0.5, 0.4, 0.2, 0.05}) {
      const BranchImage drawn = filtered_on_gpu(flat({120, 90}, level), module);
      for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
        ASSERT_LE(drawn.pixels[i].colour.r, before.pixels[i].colour.r + 1e-5) << level;
      before = drawn;
    }
  }
}

/// A cylinder whose axis is turned in the picture and tilted out of it.
struct Cylinder {
  double turned_degrees;
  double tilted_degrees;
  double radius_px = 230.0;
  glm::dvec2 middle_px{240.0};

  glm::dvec2 axis() const {
    const double angle = glm::radians(turned_degrees);
    return {std::cos(angle), -std::sin(angle)};
  }
  /// How far from the axis, as a share of the radius.
  double aside(glm::dvec2 at) const {
    return glm::dot(at - middle_px, glm::dvec2(-axis().y, axis().x)) / radius_px;
  }
  glm::dvec3 normal(glm::dvec2 at) const {
    const double side = std::clamp(aside(at), -0.99, 0.99);
    const double front = std::sqrt(1.0 - side * side);
    const double tilt = glm::radians(tilted_degrees);
    const glm::dvec2 in_picture =
        side * glm::dvec2(-axis().y, axis().x) - front * std::sin(tilt) * axis();
    return {in_picture, front * std::cos(tilt)};
  }
  /// Of its circumference, as the camera sees it.
  double girth_degrees(glm::dvec2 at) const {
    const double side = aside(at);
    const double front = std::sqrt(1.0 - side * side);
    const glm::dvec2 girth = front * glm::dvec2(-axis().y, axis().x) +
                             side * std::sin(glm::radians(tilted_degrees)) * axis();
    return glm::degrees(std::atan2(-girth.y, girth.x));
  }
};

TEST(Hatching, RunsAboutACylinder) {
  for (const Cylinder& cylinder :
       {Cylinder{0, 0}, Cylinder{35, 0}, Cylinder{90, 30}, Cylinder{20, 45}, Cylinder{-70, 50}}) {
    const BranchImage shaded =
        surface({480, 480}, 0.6, [&](glm::dvec2 at) { return cylinder.normal(at); });
    const BranchImage drawn =
        filtered_on_gpu(shaded, hatching({{"length", 60}, {"width", 3}, {"cross_from", 1}}));
    for (const double aside : {-0.5, 0.0, 0.5}) {
      const glm::dvec2 across(-cylinder.axis().y, cylinder.axis().x);
      double off = 0.0;
      for (int i = -2; i <= 2; ++i) {
        const glm::dvec2 at =
            cylinder.middle_px + aside * cylinder.radius_px * across + 40.0 * i * cylinder.axis();
        const glm::ivec2 begin = glm::ivec2(at) - 24;
        const double apart = stroke_degrees(drawn, begin, begin + 48) - cylinder.girth_degrees(at);
        off += (std::remainder(apart, 180.0)) / 5.0;
      }
      EXPECT_NEAR(off, 0.0, 2.0) << cylinder.turned_degrees << " " << cylinder.tilted_degrees << " "
                                 << aside;
    }
  }
}

TEST(Hatching, IsParallelWhereCurvatureMeansNothing) {
  const BranchImage plane = flat({200, 200}, 0.6);
  const BranchImage ball = surface({200, 200}, 0.6, [](glm::dvec2 at) {
    const glm::dvec2 off = (at - 100.0) / 150.0;
    return glm::dvec3(off, std::sqrt(1.0 - glm::dot(off, off)));
  });
  for (const BranchImage* image : {&plane, &ball}) {
    for (const double angle : {20.0, 120.0}) {
      const BranchImage drawn = filtered_on_gpu(
          *image, hatching({{"angle_degrees", angle}, {"width", 3}, {"cross_from", 1}}));
      EXPECT_LT(between_degrees(stroke_degrees(drawn, {40, 40}, {160, 160}), angle), 2.0)
          << angle << (image == &ball ? " of a ball" : " of a plane");
    }
  }
}

TEST(Hatching, CrossesFromADarknessOn) {
  const auto direction_of = [](double level, double cross_from) {
    const BranchImage drawn =
        filtered_on_gpu(flat({200, 200}, level), hatching({{"direction", "parallel"},
                                                           {"angle_degrees", 30},
                                                           {"width", 3},
                                                           {"cross_from", cross_from}}));
    return stroke_degrees(drawn, {10, 10}, {190, 190});
  };
  EXPECT_LT(between_degrees(direction_of(0.55, 0.5), 30.0), 2.0);
  EXPECT_GT(between_degrees(direction_of(0.3, 0.2), 30.0), 20.0);
  EXPECT_LT(between_degrees(direction_of(0.3, 1.0), 30.0), 2.0);
}

/// Darker, and crossed from the lightest tone on.
TEST(Hatching, HasAFamilyForTheLensWall) {
  BranchImage image = flat({300, 150}, 0.7);
  for (int y = 0; y < 150; ++y) {
    for (int x = 150; x < 300; ++x) image.at({x, y}).behind_lens = 1.0;
  }
  for (const char* direction : kDirections) {
    for (const double darker : {0.0, 0.5}) {
      const BranchImage drawn = filtered_on_gpu(
          image,
          hatching(
              {{"direction", direction}, {"wall_darker", darker}, {"width", 3}, {"length", 96}}));
      EXPECT_NEAR(mean_ink(drawn, {0, 0}, {150, 150}), 0.3, 0.05);
      EXPECT_NEAR(mean_ink(drawn, {150, 0}, {300, 150}), 0.3 + 0.7 * darker, 0.05);
      EXPECT_GT(agreement(drawn, {10, 10}, {140, 140}), 0.75);
      EXPECT_LT(agreement(drawn, {160, 10}, {290, 140}), 0.6) << "crossed";
    }
  }
}

}  // namespace
}  // namespace cutaway::test
