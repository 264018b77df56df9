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

double rate_of_one_thread(const Pixels& picture, int quality, double seconds) {
  const auto begun = Clock::now();
  int pictures = 0;
  double spent_s = 0.0;
  do {
    jpeg_of(picture, quality);
    ++pictures;
    spent_s = std::chrono::duration<double>(Clock::now() - begun).count();
  } while (spent_s < seconds);
  return pictures / spent_s;
}

double rate_together(const Pixels& picture, int quality, int threads, double seconds) {
  std::vector<double> rates(static_cast<std::size_t>(threads));
  std::latch all_ready(threads);
  {
    std::vector<std::jthread> workers;
    workers.reserve(rates.size());
    for (double& rate : rates) {
      workers.emplace_back([&] {
        jpeg_of(picture, quality);  // makes the thread's compressor
        all_ready.arrive_and_wait();
        rate = rate_of_one_thread(picture, quality, seconds);
      });
    }
  }
  return std::accumulate(rates.begin(), rates.end(), 0.0);
}

}  // namespace

std::vector<std::uint8_t> jpeg_of(const Pixels& picture, int quality) {
  const auto& planes = picture.planes;
  return encode_jpeg({.width_px = picture.size_px.x,
                      .height_px = picture.size_px.y,
                      .halved_chroma = picture.layout == PixelLayout::yuv420,
                      .planes = {planes.at(0), planes.at(1), planes.at(2)}},
                     quality);
}

std::vector<JpegRate> measure_jpeg(const Pixels& picture, int quality, std::span<const int> threads,
                                   double seconds) {
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

std::size_t bytes_of(const Pixels& picture) {
  std::size_t bytes = 0;
  for (const auto& plane : picture.planes) bytes += plane.size();
  return bytes;
}

}  // namespace cutaway::benchmark
