#include "session/link_estimate.h"

#include <algorithm>

namespace cutaway {

namespace {

constexpr double kWeight = 0.15;  // of the newest acknowledgement
// Of the mean bytes: frames closer together than that tell nothing.
constexpr double kLeastSpread = 0.05;

}  // namespace

void LinkEstimate::acknowledged(std::size_t bytes_in_flight, Milliseconds round_trip) {
  const auto bytes = static_cast<double>(bytes_in_flight);
  if (observed_++ == 0) {
    mean_bytes_ = bytes;
    mean_ms_ = round_trip.count();
    return;
  }
  const double from_mean_bytes = bytes - mean_bytes_;
  const double from_mean_ms = round_trip.count() - mean_ms_;
  mean_bytes_ += kWeight * from_mean_bytes;
  mean_ms_ += kWeight * from_mean_ms;
  variance_bytes_ =
      (1.0 - kWeight) * (variance_bytes_ + (kWeight * from_mean_bytes * from_mean_bytes));
  covariance_ = (1.0 - kWeight) * (covariance_ + (kWeight * from_mean_bytes * from_mean_ms));
}

Milliseconds LinkEstimate::transfer_time(std::size_t bytes) const {
  return Milliseconds(milliseconds_per_byte() * static_cast<double>(bytes));
}

Milliseconds LinkEstimate::latency() const {
  return Milliseconds(std::max(0.0, mean_ms_ - (milliseconds_per_byte() * mean_bytes_)));
}

double LinkEstimate::milliseconds_per_byte() const {
  const double least_spread = 1.0 + (kLeastSpread * mean_bytes_);
  return std::max(0.0, covariance_ / (variance_bytes_ + (least_spread * least_spread)));
}

}  // namespace cutaway
