#include "benchmark/samples.h"

#include <gtest/gtest.h>

namespace cutaway::benchmark {
namespace {

TEST(Median, IsTheMiddleOrBetweenTheMiddleTwo) {
  EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_EQ(median({7.0}), 7.0);
  EXPECT_EQ(median({}), 0.0);
}

TEST(Quantile, IsLinearBetweenNeighbours) {
  const std::vector<double> samples = {40.0, 10.0, 30.0, 20.0, 0.0};
  EXPECT_EQ(quantile(samples, 0.0), 0.0);
  EXPECT_EQ(quantile(samples, 1.0), 40.0);
  EXPECT_DOUBLE_EQ(quantile(samples, 0.95), 38.0);
}

}  // namespace
}  // namespace cutaway::benchmark
