// The run's own clock: what a client echoes and every figure counts from.
#pragma once

#include "load/link.h"

namespace cutaway::load {

class RunClock {
 public:
  explicit RunClock(TimePoint start) : start_(start) {}

  double seconds(TimePoint time) const { return Seconds(time - start_).count(); }
  double now_s() const { return seconds(Clock::now()); }
  TimePoint at(double seconds) const {
    return start_ + std::chrono::round<Clock::duration>(Seconds(seconds));
  }

 private:
  TimePoint start_;
};

}  // namespace cutaway::load
