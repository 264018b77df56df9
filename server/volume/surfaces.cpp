#include <string>

#include "core/check.h"
#include "volume/histogram.h"

namespace cutaway {

namespace {

/// Weight and first moment of the bins before each bin, so that any class costs two look-ups.
class Moments {
 public:
  explicit Moments(const std::vector<std::uint64_t>& counts)
      : weight_(counts.size() + 1), moment_(counts.size() + 1) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      weight_[i + 1] = weight_[i] + double(counts[i]);
      moment_[i + 1] = moment_[i] + double(counts[i]) * double(i);
    }
  }

  /// What the class of bins [begin, end) adds to the between-class variance, up to a constant.
  double contribution(int begin, int end) const {
    const double weight = weight_[end] - weight_[begin];
    const double moment = moment_[end] - moment_[begin];
    return weight > 0.0 ? moment * moment / weight : 0.0;
  }

 private:
  std::vector<double> weight_;
  std::vector<double> moment_;
};

/// The best partition of the bins before `end` into classes, for each `end`: as the variance is a
/// sum over classes, the best partition into m classes extends a best one into m - 1 (dynamic
/// programming instead of trying all).
struct Partition {
  std::vector<double> variance;
  std::vector<int> last_begin;
};

Partition add_class(const Partition& before, const Moments& moments) {
  const int bins = int(before.variance.size()) - 1;
  Partition next{std::vector<double>(bins + 1, 0.0), std::vector<int>(bins + 1, 0)};
  for (int end = 1; end <= bins; ++end) {
    next.variance[end] = -1.0;
    for (int begin = 0; begin < end; ++begin) {
      const double variance = before.variance[begin] + moments.contribution(begin, end);
      if (variance <= next.variance[end]) continue;
      next.variance[end] = variance;
      next.last_begin[end] = begin;
    }
  }
  return next;
}

/// Every cut within a run of empty bins is equally good; the middle is farthest from both classes.
double middle_of_gap(const std::vector<std::uint64_t>& counts, int cut) {
  int begin = cut;
  int end = cut;
  while (begin > 0 && counts[begin - 1] == 0) --begin;
  while (end < int(counts.size()) && counts[end] == 0) ++end;
  return 0.5 * (begin + end);
}

}  // namespace

std::vector<double> otsu_thresholds(const Histogram& histogram, int levels) {
  check(levels >= 2 && levels <= 4, "levels is " + std::to_string(levels));
  const int bins = int(histogram.counts.size());
  const Moments moments(histogram.counts);
  std::vector<Partition> partitions(1);
  partitions[0].variance.resize(bins + 1);
  for (int end = 0; end <= bins; ++end) partitions[0].variance[end] = moments.contribution(0, end);
  for (int i = 1; i < levels; ++i) partitions.push_back(add_class(partitions.back(), moments));

  std::vector<double> thresholds(levels - 1);
  const double bin_width = (histogram.range.maximum - histogram.range.minimum) / bins;
  for (int i = levels - 1, end = bins; i >= 1; --i) {
    end = partitions[i].last_begin[end];
    thresholds[i - 1] = histogram.range.minimum + bin_width * middle_of_gap(histogram.counts, end);
  }
  return thresholds;
}

SuggestedSurfaces suggest_surfaces(const Histogram& histogram) {
  const std::vector<double> thresholds = otsu_thresholds(histogram, 3);
  return {thresholds[0], thresholds[1]};
}

}  // namespace cutaway
