#include "load/report_table.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "load/figures.h"

namespace cutaway::load {

namespace {

constexpr std::size_t kShownClients = 40;
constexpr std::size_t kSlowest = 10;

class Table {
 public:
  explicit Table(std::ostream& out) : out_(out) {}

  void row(const std::string& name, const std::vector<std::string>& cells) const {
    out_ << "  " << std::left << std::setw(26) << name << std::right;
    for (const std::string& cell : cells) out_ << std::setw(11) << cell;
    out_ << '\n';
  }
  void spread(const std::string& name, const Distribution& of) const {
    if (of.count == 0) return row(name, {"0"});
    row(name, {std::to_string(of.count), figure(of.mean), figure(of.p50), figure(of.p95),
               figure(of.p99), figure(of.max)});
  }

 private:
  std::ostream& out_;
};

void print_head(std::ostream& out, const Script& script, const Summary& all) {
  out << script.title << ": " << all.clients.size() << " clients for " << figure(all.seconds, "s")
      << '\n';
  out << all.server << " on " << all.renderer << '\n';
  out << "Figures of the time when all had a frame: " << figure(all.window.begin_s) << " to "
      << figure(all.window.end_s, "s") << "\n\n";
}

void print_together(std::ostream& out, const Summary& all) {
  const Table table(out);
  table.row("together", {"count", "mean", "p50", "p95", "p99", "max"});
  table.spread("input to frame, ms", all.latency_ms);
  table.spread("time to first frame, s", all.first_frame_s);
  table.spread("last input to still, s", all.still_s);
  table.spread("server's rendering, ms", all.render_ms);
  table.spread("server's encoding, ms", all.encode_ms);
  table.spread("bytes a frame", all.bytes_per_frame);
  table.spread("load client's own lag, ms", all.input_lag_ms);
  table.row("frame bytes a second", {figure(std::round(all.bytes_per_second))});
  table.row("text bytes a second", {figure(std::round(all.text_bytes_per_second))});
  table.row("errors", {std::to_string(all.errors)});
  table.row("stale frames", {std::to_string(all.stale_frames)});
  table.row("disconnects", {std::to_string(all.disconnects)});
  if (all.latency_growth_ms) table.row("latency growth, ms", {figure(*all.latency_growth_ms)});
  if (!all.memory.empty())
    table.row("memory, first last, MiB",
              {figure(all.memory.front().mib), figure(all.memory.back().mib)});
  if (all.memory_growth_mib) table.row("memory growth, MiB", {figure(*all.memory_growth_mib)});
}

void print_roles(std::ostream& out, const Summary& all) {
  const Table table(out);
  out << '\n';
  table.row("role", {"clients", "fps mean", "fps least", "fps most", "fairness", "p50 ms", "p95 ms",
                     "max ms"});
  for (const RoleSummary& role : all.roles) {
    table.row(role.name + (role.judged ? "" : " (not judged)"),
              {std::to_string(role.clients), figure(role.frames_per_second.mean),
               figure(role.least_frames_per_second), figure(role.frames_per_second.max),
               role.fairness ? figure(*role.fairness) : "-", figure(role.latency_ms.p50),
               figure(role.latency_ms.p95), figure(role.latency_ms.max)});
  }
}

bool in_trouble(const ClientSummary& client) {
  return client.errors > 0 || client.stale_frames > 0 || client.disconnected ||
         !client.first_frame_s;
}

std::vector<const ClientSummary*> clients_to_show(const Summary& all) {
  std::vector<const ClientSummary*> shown;
  for (const ClientSummary& client : all.clients) shown.push_back(&client);
  if (shown.size() <= kShownClients) return shown;
  std::ranges::stable_sort(shown, {}, [](const ClientSummary* client) {
    return std::pair(!in_trouble(*client), client->counted ? client->frames_per_second : 1e300);
  });
  shown.resize(kSlowest);
  return shown;
}

void print_clients(std::ostream& out, const Summary& all) {
  const auto shown = clients_to_show(all);
  const Table table(out);
  out << '\n';
  table.row(
      shown.size() < all.clients.size() ? "slowest clients" : "client",
      {"fps", "p50 ms", "p95 ms", "max ms", "first s", "still s", "B/frame", "B/s", "errors"});
  for (const ClientSummary* client : shown) {
    const std::string& role = all.roles[static_cast<std::size_t>(client->role)].name;
    table.row(
        std::to_string(client->index) + " " + role,
        {client->counted ? figure(client->frames_per_second) : "-", figure(client->latency_ms.p50),
         figure(client->latency_ms.p95), figure(client->latency_ms.max),
         client->first_frame_s ? figure(*client->first_frame_s) : "-", figure(client->still_s.p50),
         figure(std::round(client->bytes_per_frame)), figure(std::round(client->bytes_per_second)),
         std::to_string(client->errors)});
  }
}

void print_troubles(std::ostream& out, const Summary& all) {
  std::size_t printed = 0;
  for (const ClientSummary& client : all.clients) {
    const std::string who = "  client " + std::to_string(client.index) + ": ";
    if (client.disconnected && printed++ < kSlowest) out << who << client.disconnect_reason << '\n';
    for (const std::string& text : client.error_texts)
      if (printed++ < kSlowest) out << who << text << '\n';
  }
}

void print_checks(std::ostream& out, const std::vector<Check>& checks) {
  out << '\n';
  for (const Check& check : checks) {
    out << (check.held ? "  held      " : "  NOT HELD  ") << std::left << std::setw(26)
        << check.name << std::right << "expected " << check.expected << ", measured "
        << check.measured << '\n';
  }
}

}  // namespace

void print_table(std::ostream& out, const Script& script, const Summary& summary,
                 const std::vector<Check>& checks) {
  print_head(out, script, summary);
  print_together(out, summary);
  print_roles(out, summary);
  print_clients(out, summary);
  print_troubles(out, summary);
  print_checks(out, checks);
}

}  // namespace cutaway::load
