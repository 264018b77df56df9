#include "volume/phantom/shape.h"

#include <gtest/gtest.h>

#include <random>

#include "volume/phantom/tissue.h"

namespace cutaway::phantom {
namespace {

std::vector<ShapePtr> every_shape() {
  const ShapePtr egg = ellipsoid({10, 0, 0}, {30, 12, 20});
  const ShapePtr bent = tube({{{-20, 0, 0}, 6}, {{0, 20, 5}, 3}, {{25, 0, 10}, 9}}, {1, 1, 0.6f});
  return {sphere({1, 2, 3}, 10),
          egg,
          ellipsoid({0, 5, 0}, {8, 30, 15}, {1, 0.5f, 1}),
          rounded_box({0, 0, 5}, {20, 10, 15}, 4, {0.3f, 0, 1}),
          half_space({0, 0, 3}, {1, 2, 1}),
          bent,
          join(8, {egg, bent, sphere({0, 0, 20}, 12)}),
          carve(5, egg, bent),
          grow(-3, complement(egg)),
          both_sides(egg),
          reflected(moved({3, 4, 5}, bent)),
          roughen({3, 8, 5}, egg),
          groove({5, 12, 0.25f, 3}, sphere({0, 0, 0}, 30))};
}

template <typename Check>
void check_in_random_balls(const ShapePtr& shape, const Check& check) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> place(-50.0f, 50.0f);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int i = 0; i < 100; ++i) {
    const Ball ball{{place(random), place(random), place(random)},
                    2.0f + 8.0f * std::abs(unit(random))};
    std::vector<glm::vec3> positions;
    while (positions.size() < 50) {
      const glm::vec3 q(unit(random), unit(random), unit(random));
      if (glm::length(q) <= 1.0f) positions.push_back(ball.centre_mm + ball.radius_mm * q);
    }
    check(*shape, ball, positions);
  }
}

TEST(Shape, DistancesStayWithinTheirBounds) {
  for (const ShapePtr& shape : every_shape()) {
    check_in_random_balls(shape, [](const Shape& s, const Ball& ball, const auto& positions) {
      const Bounds bounds = s.bounds(ball);
      for (const glm::vec3 p : positions) {
        ASSERT_GE(s.distance_mm(p), bounds.low_mm - 1e-3f);
        ASSERT_LE(s.distance_mm(p), bounds.high_mm + 1e-3f);
      }
    });
  }
}

void expect_same_when_pruned(const ShapePtr& shape) {
  check_in_random_balls(shape, [&](const Shape& s, const Ball& ball, const auto& positions) {
    const ShapePtr part = prune(shape, ball);
    for (const glm::vec3 p : positions) ASSERT_EQ(part->distance_mm(p), s.distance_mm(p));
  });
}

TEST(Shape, LeavingPartsOutChangesNoDistance) {
  for (const ShapePtr& shape : every_shape()) expect_same_when_pruned(shape);
}

TEST(Shape, LeavingPartsOutChangesNoTissueOfAPhantom) {
  for (const Layers& layers : {head_layers(), abdomen_layers(), knees_layers()}) {
    for (const Layer& layer : layers) expect_same_when_pruned(layer.shape);
  }
}

TEST(Shape, DistancesOfSimpleSolidsAreExact) {
  EXPECT_FLOAT_EQ(sphere({1, 0, 0}, 2)->distance_mm({6, 0, 0}), 3.0f);
  EXPECT_FLOAT_EQ(rounded_box({0, 0, 0}, {4, 5, 6}, 1)->distance_mm({0, 0, 9}), 3.0f);
  EXPECT_FLOAT_EQ(half_space({0, 0, 2}, {0, 0, 2})->distance_mm({7, 7, 5}), 3.0f);
  EXPECT_FLOAT_EQ(rod({{{0, 0, 0}, 2}, {{0, 0, 10}, 2}})->distance_mm({5, 0, 5}), 3.0f);
  EXPECT_NEAR(ellipsoid({0, 0, 0}, {3, 4, 5})->distance_mm({0, 0, 6}), 1.0f, 1e-5f);
}

TEST(Shape, ATaperingRodIsTheHullOfItsBalls) {
  const Knot a{{3, -4, 2}, 2};
  const Knot b{{12, 5, 9}, 7};
  const ShapePtr shape = rod({a, b});
  for (const glm::vec3 p : {glm::vec3(20, 0, 0), {-5, 9, 1}, {3, -9, 3}, {9, 9, -4}, {25, 9, 16}}) {
    float nearest = 1e9f;
    for (int i = 0; i <= 4000; ++i) {
      const float t = float(i) / 4000.0f;
      const glm::vec3 centre = glm::mix(a.position_mm, b.position_mm, t);
      nearest = std::min(nearest, glm::length(p - centre) - glm::mix(a.radius_mm, b.radius_mm, t));
    }
    EXPECT_NEAR(shape->distance_mm(p), nearest, 1e-3f);
  }
}

TEST(Shape, ATubePassesThroughItsKnots) {
  const std::vector<Knot> knots{{{0, 0, 0}, 2}, {{10, 5, 0}, 3}, {{20, 0, 8}, 1}};
  const ShapePtr shape = tube(knots);
  for (const Knot& knot : knots) {
    EXPECT_NEAR(shape->distance_mm(knot.position_mm), -knot.radius_mm, 0.3f);
  }
}

TEST(Shape, ReflectionExchangesLeftAndRight) {
  const ShapePtr left = sphere({10, 0, 0}, 2);
  EXPECT_LT(left->distance_mm({10, 0, 0}), 0.0f);
  EXPECT_GT(reflected(left)->distance_mm({10, 0, 0}), 0.0f);
  EXPECT_LT(reflected(left)->distance_mm({-10, 0, 0}), 0.0f);
  EXPECT_LT(both_sides(left)->distance_mm({-10, 0, 0}), 0.0f);
  EXPECT_LT(both_sides(left)->distance_mm({10, 0, 0}), 0.0f);
}

}  // namespace
}  // namespace cutaway::phantom
