#include "session/pacer.h"

#include <algorithm>

namespace cutaway {

namespace {

TimePoint after(TimePoint time, Milliseconds span) {
  return time + std::chrono::ceil<SessionClock::duration>(span);
}

}  // namespace

void Pacer::changed(TimePoint now, bool has_finish) {
  change_due_ = true;
  still_due_ = true;
  finish_due_ = has_finish;
  last_change_ = now;
}

void Pacer::asked(FrameKind kind, TimePoint now) {
  change_due_ = false;
  if (kind != FrameKind::interactive) still_due_ = false;
  if (kind == FrameKind::finished) finish_due_ = false;
  last_asked_ = now;
}

void Pacer::give_up() {
  change_due_ = false;
  still_due_ = false;
  finish_due_ = false;
}

FrameKind Pacer::kind(TimePoint now) const {
  if (now < still_due()) return FrameKind::interactive;
  return still_due_ || change_due_ || !finish_due_ ? FrameKind::still : FrameKind::finished;
}

std::optional<FrameKind> Pacer::due(TimePoint now) const {
  if (still_due_ && now >= still_due()) return FrameKind::still;
  if (change_due_ && now >= interactive_due()) return FrameKind::interactive;
  if (finish_due_ && now >= still_due()) return FrameKind::finished;
  return std::nullopt;
}

std::optional<TimePoint> Pacer::next_due(TimePoint now) const {
  if (due(now) || !still_due_) return std::nullopt;
  return change_due_ ? std::min(interactive_due(), still_due()) : still_due();
}

TimePoint Pacer::interactive_due() const {
  return last_asked_ ? after(*last_asked_, interval_) : last_change_;
}

TimePoint Pacer::still_due() const { return after(last_change_, rest_); }

}  // namespace cutaway
