#include "load/statistics.h"

#include <gtest/gtest.h>

#include <numeric>

#include "load/figures.h"

namespace cutaway::load {
namespace {

std::vector<double> one_to(int most) {
  std::vector<double> samples(static_cast<std::size_t>(most));
  std::iota(samples.begin(), samples.end(), 1.0);
  return samples;
}

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(percentile(one_to(100), 50), 50.0);
  EXPECT_EQ(percentile(one_to(100), 95), 95.0);
  EXPECT_EQ(percentile(one_to(10), 95), 10.0);
  EXPECT_EQ(percentile(one_to(100), 0), 1.0);
  EXPECT_EQ(percentile(one_to(100), 100), 100.0);
  EXPECT_EQ(percentile({3.0, 1.0, 2.0}, 50), 2.0);
  EXPECT_EQ(percentile({4.0}, 99), 4.0);
}

TEST(Percentile, IsNothingWithoutSamples) {
  EXPECT_FALSE(percentile({}, 50));
  EXPECT_FALSE(mean({}));
  EXPECT_EQ(distribution({}).count, 0U);
}

TEST(Distribution, HasAllOfThem) {
  const Distribution of = distribution(one_to(1000));
  EXPECT_EQ(of.count, 1000U);
  EXPECT_DOUBLE_EQ(of.mean, 500.5);
  EXPECT_EQ(of.p50, 500.0);
  EXPECT_EQ(of.p95, 950.0);
  EXPECT_EQ(of.p99, 990.0);
  EXPECT_EQ(of.max, 1000.0);
}

TEST(Fairness, IsTheLargestDeviationFromTheMean) {
  const std::vector<double> rates = {8.0, 10.0, 12.0, 10.0};
  EXPECT_DOUBLE_EQ(*largest_relative_deviation(rates), 0.2);
  const std::vector<double> starved = {0.0, 10.0, 20.0};
  EXPECT_DOUBLE_EQ(*largest_relative_deviation(starved), 1.0);
  const std::vector<double> alone = {3.0};
  EXPECT_DOUBLE_EQ(*largest_relative_deviation(alone), 0.0);
}

TEST(Fairness, IsNothingWhereNobodyIsServed) {
  const std::vector<double> nobody = {0.0, 0.0};
  EXPECT_FALSE(largest_relative_deviation(nobody));
  EXPECT_FALSE(largest_relative_deviation({}));
}

TEST(Histogram, PutsWhatIsAboveIntoTheLastBin) {
  const std::vector<double> samples = {0.0, 9.9, 10.0, 39.0, 1000.0};
  const std::vector<Bin> bins = histogram(samples, 40.0, 4);
  ASSERT_EQ(bins.size(), 4U);
  EXPECT_EQ(bins[0].count, 2U);
  EXPECT_EQ(bins[1].count, 1U);
  EXPECT_EQ(bins[2].count, 0U);
  EXPECT_EQ(bins[3].count, 2U);
  EXPECT_DOUBLE_EQ(bins[3].to, 40.0);
}

TEST(Figure, HasTheDigitsThatSaySomething) {
  EXPECT_EQ(figure(1234.56), "1235");
  EXPECT_EQ(figure(12.345), "12.3");
  EXPECT_EQ(figure(1.2345), "1.23");
  EXPECT_EQ(figure(0.01234), "0.012");
  EXPECT_EQ(figure(3.0, "ms"), "3 ms");
  EXPECT_EQ(figure(0.0, ""), "0");
}

}  // namespace
}  // namespace cutaway::load
