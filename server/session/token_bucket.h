// A rate limit that allows bursts.
#pragma once

#include <algorithm>

#include "session/strand.h"

namespace cutaway {

class TokenBucket {
 public:
  TokenBucket(double per_second, double burst, TimePoint now)
      : per_second_(per_second), burst_(burst), tokens_(burst), filled_at_(now) {}

  /// False where the rate is exceeded.
  bool take(TimePoint now) {
    fill(now);
    if (tokens_ < 1.0) return false;
    tokens_ -= 1.0;
    return true;
  }

  /// Takes what there may not be: until the debt is paid, `take` answers false.
  void charge(TimePoint now, double tokens) {
    fill(now);
    tokens_ -= tokens;
  }

  /// Takes no more than leaves `least`, where there is that much.
  void charge_above(TimePoint now, double tokens, double least) {
    fill(now);
    tokens_ = std::min(tokens_, std::max(least, tokens_ - tokens));
  }

 private:
  void fill(TimePoint now) {
    const double seconds = std::chrono::duration<double>(now - filled_at_).count();
    tokens_ = std::min(burst_, tokens_ + (seconds * per_second_));
    filled_at_ = now;
  }

  double per_second_;
  double burst_;
  double tokens_;
  TimePoint filled_at_;
};

}  // namespace cutaway
