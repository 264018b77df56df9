// A slow link, simulated by the receiver.
#pragma once

#include <chrono>
#include <cstddef>

#include "load/script.h"

namespace cutaway::load {

using Clock = std::chrono::steady_clock;
using TimePoint = Clock::time_point;
using Seconds = std::chrono::duration<double>;

/// Says when bytes that the sender has handed over would have come through. Knows no clock and no
/// socket: the reader waits until then before it reads on, so that the sender feels the link.
class SimulatedLink {
 public:
  explicit SimulatedLink(const LinkSettings& settings) : settings_(settings) {}

  bool limited() const { return settings_.bytes_per_second > 0; }
  /// Bytes to read at once: few enough that the link's rate is even within a picture.
  std::size_t chunk_bytes() const;
  /// The kernel's receive buffer, so that it hides no queue; 0: as the kernel chooses.
  int receive_buffer_bytes() const;

  /// When the link's end has these bytes, which the reader asked for at `asked` and got at `now`.
  /// Bytes that lay ready came while the reader was late: that is made up for, so that the rate
  /// holds. Does not decrease.
  TimePoint transferred(std::size_t bytes, TimePoint asked, TimePoint now);
  /// How long a bit travels, either way.
  Clock::duration delay() const;

 private:
  LinkSettings settings_;
  TimePoint free_at_{};
};

}  // namespace cutaway::load
