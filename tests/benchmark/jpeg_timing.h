// How many pictures a second become JPEG, with one thread and with several.
#pragma once

#include <span>
#include <vector>

#include "render/render_settings.h"

namespace cutaway::benchmark {

/// As the server compresses them: planes of `yuv420` or `yuv444`. Any thread.
std::vector<std::uint8_t> jpeg_of(const Pixels& picture, int quality);

struct JpegRate {
  int threads = 0;
  double pictures_per_second = 0.0;  ///< of all threads together, median over the rounds
};

/// Each thread compresses the same picture again and again. Each number of threads gets `seconds`,
/// in rounds that take turns, so that what slows the machine down for a while slows all of them.
std::vector<JpegRate> measure_jpeg(const Pixels& picture, int quality, std::span<const int> threads,
                                   double seconds);

/// Bytes of all planes together.
std::size_t bytes_of(const Pixels& picture);

}  // namespace cutaway::benchmark
