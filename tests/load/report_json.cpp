#include "load/report_json.h"

namespace cutaway::load {

namespace {

using Json = nlohmann::json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json spread(const Distribution& of) {
  if (of.count == 0) return {{"count", 0}};
  return {{"count", of.count}, {"mean", of.mean}, {"p50", of.p50},
          {"p95", of.p95},     {"p99", of.p99},   {"max", of.max}};
}

Json client_json(const ClientSummary& client, const Summary& all) {
  return {{"index", client.index},
          {"role", all.roles[static_cast<std::size_t>(client.role)].name},
          {"frames_per_second", client.counted ? Json(client.frames_per_second) : Json()},
          {"moving_s", client.moving_s},
          {"latency_ms", spread(client.latency_ms)},
          {"first_frame_s", or_null(client.first_frame_s)},
          {"still_s", spread(client.still_s)},
          {"frames", client.frames},
          {"still_frames", client.still_frames},
          {"bytes_per_frame", client.bytes_per_frame},
          {"bytes_per_second", client.bytes_per_second},
          {"errors", client.errors},
          {"error_texts", client.error_texts},
          {"stale_frames", client.stale_frames},
          {"disconnected", client.disconnected},
          {"disconnect_reason", client.disconnect_reason}};
}

Json role_json(const RoleSummary& role) {
  return {{"name", role.name},
          {"judged", role.judged},
          {"clients", role.clients},
          {"frames_per_second", spread(role.frames_per_second)},
          {"least_frames_per_second", role.least_frames_per_second},
          {"fairness", or_null(role.fairness)},
          {"latency_ms", spread(role.latency_ms)}};
}

Json together(const Summary& all) {
  return {{"latency_ms", spread(all.latency_ms)},
          {"latency_growth_ms", or_null(all.latency_growth_ms)},
          {"least_frames_per_second", or_null(all.least_frames_per_second)},
          {"fairness", or_null(all.fairness)},
          {"first_frame_s", spread(all.first_frame_s)},
          {"clients_without_frame", all.without_frame},
          {"still_s", spread(all.still_s)},
          {"render_ms", spread(all.render_ms)},
          {"encode_ms", spread(all.encode_ms)},
          {"bytes_per_frame", spread(all.bytes_per_frame)},
          {"bytes_per_second", all.bytes_per_second},
          {"text_bytes_per_second", all.text_bytes_per_second},
          {"errors", all.errors},
          {"stale_frames", all.stale_frames},
          {"disconnects", all.disconnects},
          {"input_lag_ms", spread(all.input_lag_ms)},
          {"memory_growth_mib", or_null(all.memory_growth_mib)}};
}

Json checks_json(const std::vector<Check>& checks) {
  Json list = Json::array();
  for (const Check& check : checks) {
    list.push_back({{"name", check.name},
                    {"expected", check.expected},
                    {"measured", check.measured},
                    {"held", check.held}});
  }
  return list;
}

template <typename List, typename ToJson>
Json list_json(const List& list, const ToJson& to_json) {
  Json result = Json::array();
  for (const auto& entry : list) result.push_back(to_json(entry));
  return result;
}

}  // namespace

Json json_report(const Script& script, const Summary& all, const std::vector<Check>& checks) {
  return {
      {"script", script.title},
      {"server", all.server},
      {"renderer", all.renderer},
      {"clients_count", all.clients.size()},
      {"seconds", all.seconds},
      {"window_s", {all.window.begin_s, all.window.end_s}},
      {"held", all_held(checks)},
      {"checks", checks_json(checks)},
      {"together", together(all)},
      {"roles", list_json(all.roles, role_json)},
      {"clients",
       list_json(all.clients, [&all](const auto& client) { return client_json(client, all); })},
      {"latency_over_time",
       list_json(all.latency_over_time,
                 [](const LatencySlice& slice) {
                   return Json{{"from_s", slice.from_s}, {"latency_ms", spread(slice.latency_ms)}};
                 })},
      {"memory", list_json(all.memory, [](const MemorySample& sample) {
         return Json{{"at_s", sample.at_s}, {"mib", sample.mib}};
       })}};
}

}  // namespace cutaway::load
