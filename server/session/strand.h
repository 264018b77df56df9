// Where and when a session's code runs. Sessions hold no mutex: all their code runs on their
// strand, one piece at a time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>

namespace cutaway {

using SessionClock = std::chrono::steady_clock;
using TimePoint = SessionClock::time_point;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// One alarm. Used on the strand only; destroying it clears it.
class Alarm {
 public:
  virtual ~Alarm() = default;
  /// Rings once at or after `when`, on the strand; replaces an earlier setting.
  virtual void set(TimePoint when) = 0;
  virtual void clear() = 0;
};

/// An Asio strand with its clock, or a test's queue with a clock that the test turns.
class Strand {
 public:
  virtual ~Strand() = default;
  virtual TimePoint now() const = 0;
  /// Runs `work` on the strand, later; from any thread. Work posted from one thread runs in the
  /// order of posting.
  virtual void post(std::function<void()> work) = 0;
  virtual std::unique_ptr<Alarm> make_alarm(std::function<void()> ring) = 0;
};

}  // namespace cutaway
