// What a byte costs on the way to the client, from acknowledgements.
#pragma once

#include <cstddef>

#include "session/strand.h"

namespace cutaway {

/// Fits `round trip = latency + bytes in flight / bandwidth` to the recent acknowledgements by
/// exponentially weighted least squares. So a distant client is not taken for one on a slow link:
/// only the part that grows with the bytes counts as transfer.
class LinkEstimate {
 public:
  /// `bytes_in_flight` at the moment of sending: the frame's own and those not yet acknowledged.
  void acknowledged(std::size_t bytes_in_flight, Milliseconds round_trip);

  Milliseconds transfer_time(std::size_t bytes) const;
  Milliseconds latency() const;

 private:
  double milliseconds_per_byte() const;

  int observed_ = 0;
  double mean_bytes_ = 0.0;
  double mean_ms_ = 0.0;
  double variance_bytes_ = 0.0;
  double covariance_ = 0.0;
};

}  // namespace cutaway
