#include "load/report_html.h"

#include <cmath>
#include <sstream>

#include "load/figures.h"
#include "load/plot.h"

namespace cutaway::load {

namespace {

constexpr std::size_t kBins = 40;

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1d2126; --quiet: #5c6670; --sheet: #ffffff; --rule: #dde1e6; --a: #2066b0; --b: #b0482c; --good: #1c7a3d; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e7eaee; --quiet: #9aa5b1; --sheet: #15181c; --rule: #343b43; --a: #7ab8ff; --b: #ff9d7a; --good: #6fd08c; --bad: #ff8a80; } }
body { margin: 2rem auto; max-width: 60rem; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--sheet); }
h1 { font-size: 1.6rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
p, figcaption { max-width: 45rem; } figure { margin: 1.5rem 0; } figcaption { font-weight: 600; }
svg { width: 100%; height: auto; } svg text { font-size: 12px; fill: var(--quiet); }
.grid { stroke: var(--rule); } .line { fill: none; stroke-width: 2; } .a { stroke: var(--a); } .b { stroke: var(--b); } .bar { fill: var(--a); }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 0.2rem 0.7rem; text-align: right; border-bottom: 1px solid var(--rule); white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } .held { color: var(--good); } .not { color: var(--bad); font-weight: 600; }
)";

using Row = std::vector<std::string>;

/// Cells that begin with '<' are markup already.
void table(std::ostream& out, const Row& head, const std::vector<Row>& rows) {
  out << "<div class=\"scroll\"><table><thead><tr>";
  for (const std::string& cell : head) out << "<th scope=\"col\">" << escaped(cell) << "</th>";
  out << "</tr></thead><tbody>\n";
  for (const Row& row : rows) {
    out << "<tr>";
    for (const std::string& cell : row)
      out << "<td>" << (cell.starts_with("<span") ? cell : escaped(cell)) << "</td>";
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_checks(std::ostream& out, const std::vector<Check>& checks) {
  std::vector<Row> rows;
  for (const Check& check : checks) {
    rows.push_back(
        {check.name, check.expected, check.measured,
         check.held ? "<span class=\"held\">held</span>" : "<span class=\"not\">not held</span>"});
  }
  out << "<h2>Thresholds</h2>\n";
  table(out, {"threshold", "expected", "measured", ""}, rows);
}

Row spread_row(const std::string& name, const Distribution& of) {
  return {name,           std::to_string(of.count), figure(of.mean), figure(of.p50),
          figure(of.p95), figure(of.p99),           figure(of.max)};
}

void write_together(std::ostream& out, const Summary& all) {
  out << "<h2>All clients together</h2>\n";
  table(out, {"", "samples", "mean", "p50", "p95", "p99", "max"},
        {spread_row("input to frame, ms", all.latency_ms),
         spread_row("time to first frame, s", all.first_frame_s),
         spread_row("last input to still, s", all.still_s),
         spread_row("server's rendering, ms", all.render_ms),
         spread_row("server's encoding, ms", all.encode_ms),
         spread_row("bytes a frame", all.bytes_per_frame),
         spread_row("load client's own lag, ms", all.input_lag_ms)});
}

void write_roles(std::ostream& out, const Summary& all) {
  std::vector<Row> rows;
  for (const RoleSummary& role : all.roles) {
    rows.push_back({role.name + (role.judged ? "" : " (not judged)"), std::to_string(role.clients),
                    figure(role.frames_per_second.mean), figure(role.least_frames_per_second),
                    figure(role.frames_per_second.max),
                    role.fairness ? figure(*role.fairness) : "-", figure(role.latency_ms.p50),
                    figure(role.latency_ms.p95)});
  }
  out << "<h2>Roles</h2>\n";
  table(
      out,
      {"role", "clients", "frames/s mean", "least", "most", "fairness", "latency p50 ms", "p95 ms"},
      rows);
}

void write_clients(std::ostream& out, const Summary& all) {
  std::vector<Row> rows;
  for (const ClientSummary& client : all.clients) {
    std::string trouble = client.disconnected ? client.disconnect_reason : "";
    if (!client.error_texts.empty())
      trouble += (trouble.empty() ? "" : "; ") + client.error_texts.front();
    rows.push_back(
        {std::to_string(client.index) + " " + all.roles[static_cast<std::size_t>(client.role)].name,
         client.counted ? figure(client.frames_per_second) : "-", figure(client.latency_ms.p50),
         figure(client.latency_ms.p95), figure(client.latency_ms.max),
         client.first_frame_s ? figure(*client.first_frame_s) : "-", figure(client.still_s.p50),
         figure(std::round(client.bytes_per_frame)), figure(std::round(client.bytes_per_second)),
         std::to_string(client.errors), std::to_string(client.stale_frames), trouble});
  }
  out << "<h2>Clients</h2>\n";
  table(out,
        {"client", "frames/s", "latency p50 ms", "p95 ms", "max ms", "first frame s", "still s",
         "bytes/frame", "bytes/s", "errors", "stale", "trouble"},
        rows);
}

std::string latency_histogram(const Summary& all) {
  std::vector<Bar> bars;
  if (!all.latencies_ms.empty()) {
    for (const Bin& bin : histogram(all.latencies_ms, 1.5 * all.latency_ms.p99, kBins))
      bars.push_back({figure(std::round(bin.from)), static_cast<double>(bin.count)});
  }
  return bar_plot({"Latency from input to frame, while moving",
                   "ms, the last bar and everything above it", "frames"},
                  bars);
}

std::string latency_over_time(const Summary& all) {
  Line median{"median", "a", {}};
  Line worst{"95th percentile", "b", {}};
  for (const LatencySlice& slice : all.latency_over_time) {
    if (slice.latency_ms.count == 0) continue;
    median.points.emplace_back(slice.from_s, slice.latency_ms.p50);
    worst.points.emplace_back(slice.from_s, slice.latency_ms.p95);
  }
  return line_plot({"Latency over time", "seconds since the start", "ms"}, {median, worst});
}

template <typename Value>
std::string by_client(const Axes& axes, const Summary& all, const Value& value) {
  std::vector<Bar> bars;
  for (const ClientSummary& client : all.clients)
    bars.push_back({std::to_string(client.index), value(client)});
  return bar_plot(axes, bars);
}

std::string memory_over_time(const Summary& all) {
  Line line{"resident memory", "a", {}};
  for (const MemorySample& sample : all.memory) line.points.emplace_back(sample.at_s, sample.mib);
  return line_plot({"Memory of the server", "seconds since the start", "MiB"}, {line});
}

void write_plots(std::ostream& out, const Summary& all) {
  out << "<h2>Plots</h2>\n" << latency_histogram(all) << latency_over_time(all);
  out << by_client({"Frames per second while moving, by client", "client", "frames/s"}, all,
                   [](const ClientSummary& client) { return client.frames_per_second; });
  out << by_client({"Bytes a frame, by client", "client", "bytes"}, all,
                   [](const ClientSummary& client) { return client.bytes_per_frame; });
  out << by_client({"Bytes a second, by client", "client", "bytes/s"}, all,
                   [](const ClientSummary& client) { return client.bytes_per_second; });
  if (!all.memory.empty()) out << memory_over_time(all);
}

}  // namespace

std::string html_report(const Script& script, const Summary& all,
                        const std::vector<Check>& checks) {
  std::ostringstream out;
  out << "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>"
      << escaped(script.title) << "</title><style>" << kStyle << "</style></head><body>\n<h1>"
      << escaped(script.title) << "</h1>\n<p>" << escaped(script.description) << "</p>\n<p>"
      << all.clients.size() << " clients for " << figure(all.seconds, "seconds") << " on "
      << escaped(all.server) << ", " << escaped(all.renderer)
      << ". Figures are of the time when all had a frame, from " << figure(all.window.begin_s)
      << " to " << figure(all.window.end_s, "seconds") << ".</p>\n";
  write_checks(out, checks);
  write_plots(out, all);
  write_together(out, all);
  write_roles(out, all);
  write_clients(out, all);
  out << "</body></html>\n";
  return out.str();
}

}  // namespace cutaway::load
