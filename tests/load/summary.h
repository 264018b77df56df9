// What a run measured, per client, per role and together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "load/run.h"
#include "load/statistics.h"

namespace cutaway::load {

struct ClientSummary {
  int index = 0;
  int role = 0;
  double moving_s = 0.0;           ///< in the window
  double frames_per_second = 0.0;  ///< interactive ones that arrived while moving; 0: not counted
  bool counted = false;            ///< moved long enough for a frame rate
  Distribution latency_ms;
  Distribution still_s;
  std::optional<double> first_frame_s;  ///< since its first message
  std::size_t frames = 0;               ///< live frames of the whole run
  std::size_t still_frames = 0;
  double bytes_per_frame = 0.0;
  double bytes_per_second = 0.0;  ///< of messages in the window, frames only
  std::uint64_t errors = 0;
  std::uint64_t stale_frames = 0;
  std::vector<std::string> error_texts;
  bool disconnected = false;
  std::string disconnect_reason;
};

struct RoleSummary {
  std::string name;
  bool judged = true;
  int clients = 0;
  Distribution frames_per_second;  ///< over the clients that moved long enough
  double least_frames_per_second = 0.0;
  std::optional<double> fairness;  ///< largest deviation from the mean, as a share of it
  Distribution latency_ms;
};

/// The latencies of a slice of time.
struct LatencySlice {
  double from_s = 0.0;
  Distribution latency_ms;
};

struct Summary {
  std::string server;
  std::string renderer;
  double seconds = 0.0;
  Interval window;  ///< from when every client has had a frame
  std::vector<ClientSummary> clients;
  std::vector<RoleSummary> roles;
  std::vector<double> latencies_ms;  ///< of the judged roles, in the window
  Distribution latency_ms;
  std::vector<LatencySlice> latency_over_time;  ///< whole run, judged roles
  std::optional<double> latency_growth_ms;      ///< median, last third less first third
  Distribution first_frame_s;
  int without_frame = 0;  ///< clients that never had one
  Distribution still_s;
  Distribution render_ms;  ///< of interactive frames, as the server says; encoding too
  Distribution encode_ms;
  Distribution bytes_per_frame;
  double bytes_per_second = 0.0;       ///< of frames, all clients together
  double text_bytes_per_second = 0.0;  ///< of text messages, the same, whole run
  std::optional<double> least_frames_per_second;
  std::optional<double> fairness;
  std::uint64_t errors = 0;
  std::uint64_t stale_frames = 0;
  int disconnects = 0;
  Distribution input_lag_ms;  ///< how late the load client itself was
  std::vector<MemorySample> memory;
  std::optional<double> memory_growth_mib;  ///< median, last third less middle third
};

Summary summarise(const Script& script, const RunOutcome& outcome);

}  // namespace cutaway::load
