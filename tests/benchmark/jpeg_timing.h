// How many pictures a second become JPEG, with one thread and with several.
#pragma once

#include <span>
#include <vector>

#include "core/picture.h"

namespace cutaway::benchmark {

struct JpegRate {
  int threads = 0;
  double pictures_per_second = 0.0;  ///< of all threads together, median over the rounds
};

/// `picture` is of planes, as the server compresses them. Each thread compresses the same picture
/// again and again. Each number of threads gets `seconds`, in rounds that take turns, so that what
/// slows the machine down for a while slows all of them.
std::vector<JpegRate> measure_jpeg(const Picture& picture, int quality,
                                   std::span<const int> threads, double seconds);

}  // namespace cutaway::benchmark
