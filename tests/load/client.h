// One client: speaks the protocol as protocol/README.md says, and records.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <memory>

#include "load/connection.h"
#include "load/ledger.h"
#include "load/live_counters.h"
#include "load/run_clock.h"
#include "load/script.h"
#include "load/walk.h"

namespace cutaway::load {

/// What all clients of a run share; outlives them, and does not change.
struct RunPlan {
  const Script& script;
  Address address;
  RunClock clock;
  double end_s;  ///< when every client says goodbye
};

/// Everything on the executor's one thread, but for the counters.
class Client : public std::enable_shared_from_this<Client> {
 public:
  Client(const boost::asio::any_io_executor& executor, const RunPlan& plan, LiveCounters& counters,
         int index, int role);

  /// From the start at that time to the plan's end, or to the connection's. Throws nothing.
  boost::asio::awaitable<void> run(double start_s);

  /// Once the executor has come to rest.
  const Record& record() const { return record_; }

 private:
  boost::asio::awaitable<void> serve();
  boost::asio::awaitable<void> say_goodbye();
  boost::asio::awaitable<void> move_all();
  boost::asio::awaitable<void> wait_until(boost::asio::steady_timer& timer, double at_s);
  void take(const Arrival& arrival);
  void take_text(const Json& message);
  void take_frame(const std::string& message);
  void begin(const Json& capabilities);
  void scene_is_open(const Json& scene);
  std::uint32_t send_input(Json message);
  void note_error(const std::string& text);
  void lost(const std::string& reason);
  const Role& role() const { return plan_.script.roles[static_cast<std::size_t>(record_.role)]; }

  boost::asio::any_io_executor executor_;
  const RunPlan& plan_;
  LiveCounters& counters_;
  int index_;
  Record record_;
  Ledger ledger_;
  std::shared_ptr<Connection> connection_;
  boost::asio::steady_timer motion_timer_;
  boost::asio::steady_timer end_timer_;
  std::optional<Walk> walk_;
  std::uint32_t inputs_ = 0;
  bool saying_goodbye_ = false;
};

}  // namespace cutaway::load
