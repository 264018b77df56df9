#include "volume/histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/analytic_volumes.h"

namespace cutaway {
namespace {

/// Sum of Gaussians, as counts.
struct Mode {
  double mean;
  double deviation;
  double weight;
};

Histogram mixture(ValueRange range, int bins, const std::vector<Mode>& modes) {
  Histogram histogram{.range = range, .counts = std::vector<std::uint64_t>(bins)};
  for (int bin = 0; bin < bins; ++bin) {
    const double value = range.minimum + (bin + 0.5) / bins * (range.maximum - range.minimum);
    double density = 0.0;
    for (const Mode& m : modes) {
      const double z = (value - m.mean) / m.deviation;
      density += m.weight / m.deviation * std::exp(-0.5 * z * z);
    }
    histogram.counts[bin] = std::uint64_t(std::llround(1e6 * density));
  }
  return histogram;
}

TEST(BuildHistogram, CountsStoredIntegersAndFloatsAlike) {
  Volume volume = test::quadratic_volume(test::centred_geometry(20), {.linear = {1.0, 0.0, 0.0}});
  const Histogram floats = build_histogram(volume, 10);
  EXPECT_EQ(floats.range, (ValueRange{-9.5, 9.5}));
  EXPECT_EQ(floats.counts, std::vector<std::uint64_t>(10, 800));

  std::vector<std::uint16_t> stored;
  for (const float v : std::get<std::vector<float>>(volume.voxels)) {
    stored.push_back(std::uint16_t(v + 9.5f));
  }
  volume.voxels = stored;
  volume.value_offset = -9.5;
  EXPECT_EQ(build_histogram(volume, 10).counts, floats.counts);
}

TEST(BuildHistogram, LosesNoVoxelOverSeveralChunks) {
  const Volume volume =
      test::sphere_volume(test::centred_geometry({300, 170, 90}, glm::dvec3(1.0)), 0.0);
  const Histogram histogram = build_histogram(volume, 64);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t(0)),
            300u * 170u * 90u);
}

TEST(BuildHistogram, OneValueFallsIntoTheFirstBin) {
  const Histogram histogram =
      build_histogram(test::constant_volume(test::centred_geometry(4), 5.0), 8);
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{64, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(OtsuThresholds, CutBetweenTheModesOfKnownMixtures) {
  const ValueRange range{-1000.0, 1500.0};
  const Mode air{-900.0, 30.0, 1.0};
  const Mode tissue{0.0, 40.0, 1.0};
  const Mode bone{700.0, 50.0, 1.0};
  const Mode metal{1300.0, 40.0, 1.0};
  EXPECT_NEAR(otsu_thresholds(mixture(range, 500, {air, tissue}), 2)[0], -450.0, 40.0);

  const std::vector<double> three = otsu_thresholds(mixture(range, 500, {air, tissue, bone}), 3);
  EXPECT_NEAR(three[0], -450.0, 40.0);
  EXPECT_NEAR(three[1], 350.0, 40.0);

  const std::vector<double> four =
      otsu_thresholds(mixture(range, 500, {air, tissue, bone, metal}), 4);
  EXPECT_NEAR(four[0], -450.0, 40.0);
  EXPECT_NEAR(four[1], 350.0, 40.0);
  EXPECT_NEAR(four[2], 1000.0, 40.0);
}

double between_class_variance(const std::vector<std::uint64_t>& counts, std::vector<int> cuts) {
  cuts.insert(cuts.begin(), 0);
  cuts.push_back(int(counts.size()));
  double sum = 0.0;
  for (std::size_t c = 1; c < cuts.size(); ++c) {
    double weight = 0.0;
    double moment = 0.0;
    for (int bin = cuts[c - 1]; bin < cuts[c]; ++bin) {
      weight += double(counts[bin]);
      moment += double(counts[bin]) * bin;
    }
    if (weight > 0.0) sum += moment * moment / weight;
  }
  return sum;
}

TEST(OtsuThresholds, AreTheBestOfAllPairsOfCuts) {
  const Histogram histogram =
      mixture({0.0, 60.0}, 60, {{8.0, 6.0, 3.0}, {22.0, 9.0, 1.0}, {45.0, 5.0, 0.4}});
  const std::vector<double> found = otsu_thresholds(histogram, 3);
  double best = 0.0;
  for (int a = 1; a < 60; ++a) {
    for (int b = a + 1; b < 60; ++b) {
      best = std::max(best, between_class_variance(histogram.counts, {a, b}));
    }
  }
  EXPECT_NEAR(between_class_variance(histogram.counts, {int(found[0]), int(found[1])}), best,
              1e-9 * best);
}

TEST(OtsuThresholds, OfFewerValuesThanLevelsStayInRangeAndInOrder) {
  Histogram histogram{.range = {0.0, 10.0}, .counts = std::vector<std::uint64_t>(10)};
  histogram.counts[4] = 100;
  const std::vector<double> thresholds = otsu_thresholds(histogram, 4);
  ASSERT_EQ(thresholds.size(), 3u);
  EXPECT_TRUE(std::is_sorted(thresholds.begin(), thresholds.end()));
  EXPECT_GE(thresholds.front(), 0.0);
  EXPECT_LE(thresholds.back(), 10.0);
}

VolumeDescription described(const char* modality, const char* units) {
  VolumeDescription description;
  description.modality = modality;
  description.units = units;
  return description;
}

TEST(SuggestWindow, IsTheFilesOwnThenTheSoftTissuesThenTheHistograms) {
  const Histogram histogram = mixture({0.0, 512.0}, 256, {{200.0, 20.0, 1.0}});
  VolumeDescription description = described("CT", "HU");
  EXPECT_EQ(suggest_window(description, histogram), (ValueRange{-160.0, 240.0}));
  description.window = ValueRange{100.0, 300.0};
  EXPECT_EQ(suggest_window(description, histogram), (ValueRange{100.0, 300.0}));
  const ValueRange of_histogram = suggest_window(described("MR", "none"), histogram);
  EXPECT_NEAR(of_histogram.minimum, 200.0 - 2.33 * 20.0, 5.0);
  EXPECT_NEAR(of_histogram.maximum, 200.0 + 2.33 * 20.0, 5.0);
}

/// A window of another slice, or of another scanner's numbers, shows one grey.
TEST(SuggestWindow, IsNotOneThatShowsNothingOfTheValues) {
  const Histogram histogram = mixture({0.0, 512.0}, 256, {{200.0, 20.0, 1.0}});
  VolumeDescription description = described("CT", "HU");
  for (const ValueRange window : {ValueRange{1000.0, 3000.0}, ValueRange{-900.0, -100.0},
                                  ValueRange{-32768.0, 32767.0}, ValueRange{200.0, 200.0}}) {
    description.window = window;
    EXPECT_EQ(suggest_window(description, histogram), (ValueRange{-160.0, 240.0}));
  }
  const Histogram lung = mixture({-1000.0, -600.0}, 256, {{-800.0, 30.0, 1.0}});
  const ValueRange of_lung = suggest_window(described("CT", "HU"), lung);
  EXPECT_NEAR(of_lung.minimum, -870.0, 10.0);
  EXPECT_NEAR(of_lung.maximum, -730.0, 10.0);
}

TEST(SuggestWindow, OfAConstantVolumeIsAroundIt) {
  const Histogram histogram{.range = {7.0, 7.0}, .counts = {64}};
  const ValueRange window = suggest_window(described("", "none"), histogram);
  EXPECT_LT(window.minimum, 7.0);
  EXPECT_GT(window.maximum, 7.0);
}

TEST(SuggestSurfaces, LieBetweenTheHistogramsModes) {
  const std::vector<Mode> modes{{20.0, 10.0, 1.0}, {200.0, 20.0, 1.0}, {400.0, 20.0, 1.0}};
  const SuggestedSurfaces surfaces = suggest_surfaces(mixture({0.0, 512.0}, 256, modes));
  EXPECT_NEAR(surfaces.outer_iso_value, 110.0, 30.0);
  EXPECT_NEAR(surfaces.inner_iso_value, 300.0, 30.0);
}

}  // namespace
}  // namespace cutaway
