// A strand that a test turns by hand, with a clock that stands still until it is told otherwise.
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "session/strand.h"

namespace cutaway::testing {

class FakeStrand final : public Strand {
 public:
  TimePoint now() const override { return now_; }

  void post(std::function<void()> work) override {
    const std::lock_guard lock(mutex_);
    work_.push_back(std::move(work));
  }

  std::unique_ptr<Alarm> make_alarm(std::function<void()> ring) override {
    return std::make_unique<FakeAlarm>(*this, std::move(ring));
  }

  /// Runs what was posted, and what that posts, until nothing is left.
  void run() {
    while (auto work = take()) (*work)();
  }

  /// Rings every alarm on the way in its turn.
  void advance(Milliseconds span) {
    const TimePoint until = now_ + std::chrono::ceil<SessionClock::duration>(span);
    run();
    while (!alarms_.empty() && alarms_.begin()->first <= until) {
      now_ = std::max(now_, alarms_.begin()->first);
      FakeAlarm* alarm = alarms_.begin()->second;
      alarm->clear();
      alarm->ring();
      run();
    }
    now_ = until;
  }

  bool has_alarm() const { return !alarms_.empty(); }

 private:
  class FakeAlarm final : public Alarm {
   public:
    FakeAlarm(FakeStrand& strand, std::function<void()> ring)
        : strand_(strand), ring_(std::move(ring)) {}
    ~FakeAlarm() override { FakeAlarm::clear(); }
    FakeAlarm(const FakeAlarm&) = delete;
    FakeAlarm& operator=(const FakeAlarm&) = delete;

    void set(TimePoint when) override {
      clear();
      strand_.alarms_.emplace(when, this);
    }
    void clear() override {
      std::erase_if(strand_.alarms_, [this](const auto& entry) { return entry.second == this; });
    }
    void ring() { ring_(); }

   private:
    FakeStrand& strand_;
    std::function<void()> ring_;
  };

  std::optional<std::function<void()>> take() {
    const std::lock_guard lock(mutex_);
    if (work_.empty()) return std::nullopt;
    auto work = std::move(work_.front());
    work_.pop_front();
    return work;
  }

  TimePoint now_{std::chrono::hours(1)};
  std::multimap<TimePoint, FakeAlarm*> alarms_;
  std::mutex mutex_;
  std::deque<std::function<void()>> work_;
};

}  // namespace cutaway::testing
