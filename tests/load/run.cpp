#include "load/run.h"

#include <boost/asio/io_context.hpp>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "load/client.h"

namespace cutaway::load {

namespace {

namespace asio = boost::asio;

/// Some of the clients, on one thread: they share nothing, so nothing needs a strand.
struct Crew {
  asio::io_context context{1};
  std::vector<std::shared_ptr<Client>> clients;
};

/// Wakes the calling thread once every crew has come to rest.
class Rest {
 public:
  explicit Rest(int crews) : busy_(crews) {}

  void one_is_done() {
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) all_done_.notify_all();
  }
  /// True where all are done by then.
  bool wait_until(TimePoint time) {
    std::unique_lock lock(mutex_);
    return all_done_.wait_until(lock, time, [this] { return busy_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_done_;
  int busy_;
};

double start_s(int index, const RunSettings& settings) {
  return settings.ramp_s * index / std::max(1, settings.clients);
}

void hire(std::vector<Crew>& crews, const RunPlan& plan, const RunSettings& settings,
          LiveCounters& counters) {
  const std::vector<int> roles = assign_roles(plan.script.roles, settings.clients);
  for (int i = 0; i < settings.clients; ++i) {
    Crew& crew = crews[static_cast<std::size_t>(i) % crews.size()];
    auto client = std::make_shared<Client>(crew.context.get_executor(), plan, counters, i,
                                           roles[static_cast<std::size_t>(i)]);
    crew.clients.push_back(client);
    asio::co_spawn(
        crew.context, [client, begin_s = start_s(i, settings)] { return client->run(begin_s); },
        asio::detached);
  }
}

std::vector<Record> records_of(const std::vector<Crew>& crews, int clients) {
  std::vector<Record> records;
  for (int i = 0; i < clients; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Crew& crew = crews[index % crews.size()];
    records.push_back(crew.clients[index / crews.size()]->record());
  }
  return records;
}

void watch(const RunPlan& plan, const RunSettings& settings, Rest& rest,
           const LiveCounters& counters, const Progress& progress,
           std::vector<MemorySample>& memory) {
  int tick = 0;
  do {
    const double now_s = plan.clock.now_s();
    const auto mib = settings.watch_pid ? resident_mib(*settings.watch_pid) : std::nullopt;
    if (mib && now_s < plan.end_s) memory.push_back({now_s, *mib});
    progress(now_s, counters);
  } while (!rest.wait_until(plan.clock.at(++tick)));
}

}  // namespace

RunOutcome run_clients(const Script& script, const RunSettings& settings,
                       const Progress& progress) {
  const RunPlan plan{script, settings.address, RunClock(Clock::now()), settings.seconds};
  LiveCounters counters;
  std::vector<Crew> crews(static_cast<std::size_t>(std::min(settings.threads, settings.clients)));
  Rest rest(static_cast<int>(crews.size()));
  hire(crews, plan, settings, counters);
  RunOutcome outcome;
  {
    std::vector<std::jthread> threads;
    for (Crew& crew : crews) {
      threads.emplace_back([&crew, &rest] {
        crew.context.run();
        rest.one_is_done();
      });
    }
    watch(plan, settings, rest, counters, progress, outcome.memory);
  }
  outcome.seconds = settings.seconds;
  outcome.clients = records_of(crews, settings.clients);
  return outcome;
}

}  // namespace cutaway::load
