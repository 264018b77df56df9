#include "load/summary.h"

#include <algorithm>
#include <cmath>

namespace cutaway::load {

namespace {

constexpr double kLeastMovingTime_s = 1.0;  // for a frame rate that means something
constexpr std::size_t kSlices = 60;

bool contains(const Interval& window, double at_s) {
  return at_s > window.begin_s && at_s <= window.end_s;
}

double length(const Interval& interval) { return std::max(0.0, interval.end_s - interval.begin_s); }

Interval overlap(const Interval& a, const Interval& b) {
  return {std::max(a.begin_s, b.begin_s), std::min(a.end_s, b.end_s)};
}

/// The interval's `index`-th third.
Interval third(const Interval& whole, int index) {
  const double part = length(whole) / 3.0;
  return {whole.begin_s + index * part, whole.begin_s + (index + 1) * part};
}

// A client without a frame does not hold up the others' window: it is counted by itself.
Interval window_of(const RunOutcome& outcome) {
  Interval window{0.0, outcome.seconds};
  for (const Record& client : outcome.clients)
    window.begin_s = std::max(window.begin_s, client.first_frame_s.value_or(0.0));
  return window;
}

std::vector<double> latencies(const Record& record, const Interval& window) {
  std::vector<double> samples;
  for (const FrameSample& frame : record.frames) {
    if (frame.latency_ms && contains(window, frame.at_s)) samples.push_back(*frame.latency_ms);
  }
  return samples;
}

std::vector<double> stills(const Record& record, const Interval& window) {
  std::vector<double> samples;
  for (const StillSample& still : record.stills) {
    if (contains(window, still.at_s)) samples.push_back(still.after_s);
  }
  return samples;
}

double moving_time(const Record& record, const Interval& window) {
  double sum = 0.0;
  for (const Interval& moving : record.moving) sum += length(overlap(moving, window));
  return sum;
}

void add_frames(const Record& record, const Interval& window, ClientSummary& client) {
  std::size_t in_window = 0;
  std::size_t interactive = 0;
  double bytes = 0.0;
  for (const FrameSample& frame : record.frames) {
    if (frame.still) ++client.still_frames;
    if (!contains(window, frame.at_s)) continue;
    ++in_window;
    bytes += frame.bytes;
    if (frame.moving && !frame.still) ++interactive;
  }
  client.frames = record.frames.size();
  client.bytes_per_frame = in_window > 0 ? bytes / static_cast<double>(in_window) : 0.0;
  client.bytes_per_second = length(window) > 0.0 ? bytes / length(window) : 0.0;
  client.moving_s = moving_time(record, window);
  client.counted = client.moving_s >= kLeastMovingTime_s;
  if (client.counted) client.frames_per_second = static_cast<double>(interactive) / client.moving_s;
}

ClientSummary summarise_client(const Record& record, int index, const Interval& window) {
  ClientSummary client{.index = index,
                       .role = record.role,
                       .latency_ms = distribution(latencies(record, window)),
                       .still_s = distribution(stills(record, window)),
                       .errors = record.errors,
                       .stale_frames = record.stale_frames,
                       .error_texts = record.error_texts,
                       .disconnected = record.disconnected,
                       .disconnect_reason = record.disconnect_reason};
  if (record.first_frame_s)
    client.first_frame_s = *record.first_frame_s - record.first_message_s.value_or(0.0);
  add_frames(record, window, client);
  return client;
}

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

RoleSummary summarise_role(const Role& role, int index, const RunOutcome& outcome,
                           const Summary& all) {
  RoleSummary summary{.name = role.name, .judged = role.judged()};
  std::vector<double> rates;
  std::vector<double> samples;
  for (const ClientSummary& client : all.clients) {
    if (client.role != index) continue;
    ++summary.clients;
    if (client.counted) rates.push_back(client.frames_per_second);
    append(samples, latencies(outcome.clients[static_cast<std::size_t>(client.index)], all.window));
  }
  summary.latency_ms = distribution(std::move(samples));
  if (!rates.empty()) summary.least_frames_per_second = *std::ranges::min_element(rates);
  summary.fairness = largest_relative_deviation(rates);
  summary.frames_per_second = distribution(std::move(rates));
  return summary;
}

std::vector<LatencySlice> over_time(const Script& script, const RunOutcome& outcome) {
  const double slice_s = std::max(1.0, std::ceil(outcome.seconds / kSlices));
  std::vector<std::vector<double>> samples(
      static_cast<std::size_t>(std::ceil(outcome.seconds / slice_s)));
  for (const Record& client : outcome.clients) {
    if (!script.roles[static_cast<std::size_t>(client.role)].judged()) continue;
    for (const FrameSample& frame : client.frames) {
      const auto slice = static_cast<std::size_t>(frame.at_s / slice_s);
      if (frame.latency_ms && slice < samples.size()) samples[slice].push_back(*frame.latency_ms);
    }
  }
  std::vector<LatencySlice> slices;
  for (std::size_t i = 0; i < samples.size(); ++i)
    slices.push_back({static_cast<double>(i) * slice_s, distribution(std::move(samples[i]))});
  return slices;
}

std::optional<double> growth(const std::optional<double>& before,
                             const std::optional<double>& after) {
  if (!before || !after) return std::nullopt;
  return *after - *before;
}

std::optional<double> median_memory(const std::vector<MemorySample>& memory,
                                    const Interval& window) {
  std::vector<double> samples;
  for (const MemorySample& sample : memory) {
    if (contains(window, sample.at_s)) samples.push_back(sample.mib);
  }
  return percentile(std::move(samples), 50);
}

std::optional<double> latency_growth(const Script& script, const RunOutcome& outcome,
                                     const Interval& window) {
  std::vector<double> first;
  std::vector<double> last;
  for (const Record& client : outcome.clients) {
    if (!script.roles[static_cast<std::size_t>(client.role)].judged()) continue;
    append(first, latencies(client, third(window, 0)));
    append(last, latencies(client, third(window, 2)));
  }
  return growth(percentile(std::move(first), 50), percentile(std::move(last), 50));
}

void add_clients(const RunOutcome& outcome, Summary& all) {
  for (const Record& record : outcome.clients) {
    all.text_bytes_per_second += static_cast<double>(record.text_bytes) / outcome.seconds;
    if (all.server.empty()) all.server = record.server;
    if (all.renderer.empty()) all.renderer = record.renderer;
    all.clients.push_back(
        summarise_client(record, static_cast<int>(all.clients.size()), all.window));
  }
}

void add_counts(Summary& all) {
  std::vector<double> first_frames;
  for (const ClientSummary& client : all.clients) {
    all.errors += client.errors;
    all.stale_frames += client.stale_frames;
    all.disconnects += client.disconnected ? 1 : 0;
    all.without_frame += client.first_frame_s ? 0 : 1;
    all.bytes_per_second += client.bytes_per_second;
    if (client.first_frame_s) first_frames.push_back(*client.first_frame_s);
  }
  all.first_frame_s = distribution(std::move(first_frames));
}

void add_latencies(const Script& script, const RunOutcome& outcome, Summary& all) {
  std::vector<double> rest;
  for (const Record& client : outcome.clients) {
    if (!script.roles[static_cast<std::size_t>(client.role)].judged()) continue;
    append(all.latencies_ms, latencies(client, all.window));
    append(rest, stills(client, all.window));
  }
  all.latency_ms = distribution(all.latencies_ms);
  all.still_s = distribution(std::move(rest));
}

void add_costs(const RunOutcome& outcome, Summary& all) {
  std::vector<double> bytes;
  std::vector<double> render;
  std::vector<double> encode;
  for (const Record& client : outcome.clients) {
    for (const FrameSample& frame : client.frames) {
      if (!contains(all.window, frame.at_s)) continue;
      bytes.push_back(frame.bytes);
      if (frame.still) continue;
      render.push_back(frame.render_ms);
      encode.push_back(frame.encode_ms);
    }
  }
  all.bytes_per_frame = distribution(std::move(bytes));
  all.render_ms = distribution(std::move(render));
  all.encode_ms = distribution(std::move(encode));
}

void add_lag(const RunOutcome& outcome, Summary& all) {
  std::vector<double> lag;
  for (const Record& client : outcome.clients)
    lag.insert(lag.end(), client.input_lag_ms.begin(), client.input_lag_ms.end());
  all.input_lag_ms = distribution(std::move(lag));
}

void add_roles(const Script& script, const RunOutcome& outcome, Summary& all) {
  for (std::size_t i = 0; i < script.roles.size(); ++i) {
    RoleSummary role = summarise_role(script.roles[i], static_cast<int>(i), outcome, all);
    if (role.judged && role.frames_per_second.count > 0) {
      all.least_frames_per_second =
          std::min(all.least_frames_per_second.value_or(1e300), role.least_frames_per_second);
    }
    if (role.judged && role.fairness)
      all.fairness = std::max(all.fairness.value_or(0.0), *role.fairness);
    all.roles.push_back(std::move(role));
  }
}

}  // namespace

Summary summarise(const Script& script, const RunOutcome& outcome) {
  Summary all{.seconds = outcome.seconds, .window = window_of(outcome), .memory = outcome.memory};
  add_clients(outcome, all);
  add_counts(all);
  add_latencies(script, outcome, all);
  add_costs(outcome, all);
  add_lag(outcome, all);
  add_roles(script, outcome, all);
  all.latency_over_time = over_time(script, outcome);
  all.latency_growth_ms = latency_growth(script, outcome, all.window);
  all.memory_growth_mib = growth(median_memory(all.memory, third(all.window, 1)),
                                 median_memory(all.memory, third(all.window, 2)));
  return all;
}

}  // namespace cutaway::load
