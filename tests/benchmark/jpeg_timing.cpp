#include "benchmark/jpeg_timing.h"

#include <chrono>
#include <latch>
#include <numeric>
#include <thread>

#include "benchmark/samples.h"
#include "encode/jpeg.h"

namespace cutaway::benchmark {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRounds = 5;

double rate_of_one_thread(const Picture& picture, int quality, double seconds) {
  const auto begun = Clock::now();
  int pictures = 0;
  double spent_s = 0.0;
  do {
    encode_jpeg(picture, quality);
    ++pictures;
    spent_s = std::chrono::duration<double>(Clock::now() - begun).count();
  } while (spent_s < seconds);
  return pictures / spent_s;
}

double rate_together(const Picture& picture, int quality, int threads, double seconds) {
  std::vector<double> rates(static_cast<std::size_t>(threads));
  std::latch all_ready(threads);
  {
    std::vector<std::jthread> workers;
    workers.reserve(rates.size());
    for (double& rate : rates) {
      workers.emplace_back([&] {
        encode_jpeg(picture, quality);  // makes the thread's compressor
        all_ready.arrive_and_wait();
        rate = rate_of_one_thread(picture, quality, seconds);
      });
    }
  }
  return std::accumulate(rates.begin(), rates.end(), 0.0);
}

}  // namespace

std::vector<JpegRate> measure_jpeg(const Picture& picture, int quality,
                                   std::span<const int> threads, double seconds) {
  std::vector<std::vector<double>> rates(threads.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < threads.size(); ++i)
      rates[i].push_back(rate_together(picture, quality, threads[i], seconds / kRounds));
  }
  std::vector<JpegRate> medians;
  for (std::size_t i = 0; i < threads.size(); ++i)
    medians.push_back({.threads = threads[i], .pictures_per_second = median(rates[i])});
  return medians;
}

}  // namespace cutaway::benchmark
