// A rate limit that allows bursts.
#pragma once

#include <algorithm>

#include "session/strand.h"

namespace cutaway {

/// How many messages a client may send.
struct MessageRate {
  double per_second = 300.0;  ///< on average
  double burst = 600.0;       ///< that it may have saved up
  bool operator==(const MessageRate&) const = default;
};

class TokenBucket {
 public:
  TokenBucket(const MessageRate& rate, TimePoint now)
      : rate_(rate), tokens_(rate.burst), filled_at_(now) {}

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
    tokens_ = std::min(rate_.burst, tokens_ + (seconds * rate_.per_second));
    filled_at_ = now;
  }

  MessageRate rate_;
  double tokens_;
  TimePoint filled_at_;
};

}  // namespace cutaway
