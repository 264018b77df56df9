#include "net/asio_strand.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <exception>
#include <utility>

namespace cutaway {

namespace {

void run_guarded(const std::function<void()>& work, const AsioStrand::Failed& failed) {
  try {
    work();
  } catch (const std::exception& failure) {
    failed(failure.what());
  }
}

class AsioAlarm final : public Alarm {
 public:
  AsioAlarm(const AsioStrand::Executor& executor, std::function<void()> ring,
            std::shared_ptr<const AsioStrand::Failed> failed)
      : timer_(executor),
        ring_(std::make_shared<std::function<void()>>(std::move(ring))),
        failed_(std::move(failed)) {}

  // A ring that is already on its way to the strand is told by its number that it is void.
  void set(TimePoint when) override {
    const std::uint64_t setting = ++*setting_;
    timer_.expires_at(when);
    timer_.async_wait([setting, newest = std::weak_ptr(setting_), ring = std::weak_ptr(ring_),
                       failed = failed_](boost::system::error_code error) {
      const auto current = newest.lock();
      const auto wanted = ring.lock();
      if (!error && current && wanted && *current == setting) run_guarded(*wanted, *failed);
    });
  }

  void clear() override {
    ++*setting_;
    timer_.cancel();
  }

 private:
  boost::asio::basic_waitable_timer<SessionClock, boost::asio::wait_traits<SessionClock>,
                                    AsioStrand::Executor>
      timer_;
  std::shared_ptr<std::function<void()>> ring_;
  std::shared_ptr<const AsioStrand::Failed> failed_;
  std::shared_ptr<std::uint64_t> setting_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace

AsioStrand::AsioStrand(Executor executor, Failed failed)
    : executor_(std::move(executor)), failed_(std::make_shared<const Failed>(std::move(failed))) {}

TimePoint AsioStrand::now() const { return SessionClock::now(); }

void AsioStrand::post(std::function<void()> work) {
  boost::asio::post(executor_,
                    [work = std::move(work), failed = failed_] { run_guarded(work, *failed); });
}

std::unique_ptr<Alarm> AsioStrand::make_alarm(std::function<void()> ring) {
  return std::make_unique<AsioAlarm>(executor_, std::move(ring), failed_);
}

}  // namespace cutaway
