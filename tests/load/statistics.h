// Figures from samples.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cutaway::load {

/// The smallest sample that at least `percent` of the samples do not exceed (nearest rank); nothing
/// without samples.
std::optional<double> percentile(std::vector<double> samples, double percent);
/// Nothing without samples.
std::optional<double> mean(std::span<const double> samples);
/// Largest deviation from the mean, as a share of the mean; nothing where there is no mean above 0.
std::optional<double> largest_relative_deviation(std::span<const double> samples);

/// In the unit of the samples; all 0 without samples.
struct Distribution {
  std::size_t count = 0;
  double mean = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

Distribution distribution(std::vector<double> samples);

struct Bin {
  double from = 0.0;
  double to = 0.0;
  std::size_t count = 0;
};

/// Equal bins from 0 to the largest sample shown; those above `most` fall into the last bin.
std::vector<Bin> histogram(std::span<const double> samples, double most, std::size_t bins);

}  // namespace cutaway::load
