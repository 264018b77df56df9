#include "load/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cutaway::load {

namespace {

double of_sorted(const std::vector<double>& sorted, double percent) {
  const double rank = std::ceil(percent / 100.0 * static_cast<double>(sorted.size()) - 1e-9);
  const auto index = static_cast<std::size_t>(std::max(rank, 1.0)) - 1;
  return sorted[std::min(index, sorted.size() - 1)];
}

}  // namespace

std::optional<double> percentile(std::vector<double> samples, double percent) {
  if (samples.empty()) return std::nullopt;
  std::ranges::sort(samples);
  return of_sorted(samples, percent);
}

std::optional<double> mean(std::span<const double> samples) {
  if (samples.empty()) return std::nullopt;
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

std::optional<double> largest_relative_deviation(std::span<const double> samples) {
  const std::optional<double> middle = mean(samples);
  if (!middle || *middle <= 0.0) return std::nullopt;
  double largest = 0.0;
  for (const double sample : samples)
    largest = std::max(largest, std::abs(sample - *middle) / *middle);
  return largest;
}

Distribution distribution(std::vector<double> samples) {
  if (samples.empty()) return {};
  std::ranges::sort(samples);
  return {.count = samples.size(),
          .mean = *mean(samples),
          .p50 = of_sorted(samples, 50),
          .p95 = of_sorted(samples, 95),
          .p99 = of_sorted(samples, 99),
          .max = samples.back()};
}

std::vector<Bin> histogram(std::span<const double> samples, double most, std::size_t bins) {
  const double width = most > 0.0 ? most / static_cast<double>(bins) : 1.0;
  std::vector<Bin> result;
  for (std::size_t i = 0; i < bins; ++i) {
    const auto place = static_cast<double>(i);
    result.push_back({place * width, (place + 1.0) * width, 0});
  }
  for (const double sample : samples) {
    const double place = std::clamp(sample / width, 0.0, static_cast<double>(bins - 1));
    ++result[static_cast<std::size_t>(place)].count;
  }
  return result;
}

}  // namespace cutaway::load
