// Repeated measurements of one thing.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutaway::benchmark {

/// The value below which the share `p` (0..1) of the samples lies, between neighbours linearly; 0
/// where there are none.
inline double quantile(std::vector<double> samples, double p) {
  if (samples.empty()) return 0.0;
  std::ranges::sort(samples);
  const double position = p * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, samples.size() - 1);
  return std::lerp(samples[below], samples[above], position - static_cast<double>(below));
}

inline double median(std::vector<double> samples) { return quantile(std::move(samples), 0.5); }

}  // namespace cutaway::benchmark
