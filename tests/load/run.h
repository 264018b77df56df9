// Runs all clients of a script.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "load/address.h"
#include "load/live_counters.h"
#include "load/memory_watch.h"
#include "load/record.h"
#include "load/script.h"

namespace cutaway::load {

struct RunSettings {
  Address address;
  int clients = 1;
  double seconds = 30.0;
  double ramp_s = 0.0;
  int threads = 1;
  std::optional<int> watch_pid;
};

struct RunOutcome {
  std::vector<Record> clients;
  std::vector<MemorySample> memory;
  double seconds = 0.0;
};

/// Called about once a second on the calling thread, with the time since the start, s.
using Progress = std::function<void(double, const LiveCounters&)>;

/// Blocks until every client has ended. Throws std::system_error where threads cannot be made.
RunOutcome run_clients(const Script& script, const RunSettings& settings, const Progress& progress);

}  // namespace cutaway::load
