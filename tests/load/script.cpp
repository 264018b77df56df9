#include "load/script.h"

#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

#include "load/script_check.h"
#include "load/script_error.h"

namespace cutaway::load {

namespace {

template <typename T>
void take(const Json& from, const char* name, T& value) {
  if (from.contains(name)) value = from.at(name).get<T>();
}

template <typename T>
void take(const Json& from, const char* name, std::optional<T>& value) {
  if (from.contains(name)) value = from.at(name).get<T>();
}

Motion parse_inspect(const Json& document) {
  Inspect inspect;
  take(document, "swing_degrees", inspect.swing_degrees);
  take(document, "move_s", inspect.move_s);
  take(document, "pause_s", inspect.pause_s);
  return inspect;
}

Motion parse_drag_lens(const Json& document) {
  DragLens drag;
  take(document, "centre", drag.centre);
  take(document, "radius", drag.radius);
  take(document, "turns_per_second", drag.turns_per_second);
  return drag;
}

Motion parse_zoom(const Json& document) {
  Zoom zoom;
  take(document, "nearest", zoom.nearest);
  take(document, "period_s", zoom.period_s);
  return zoom;
}

Motion parse_recorded(const Json& document, const std::string& place) {
  Recorded recorded;
  double last_s = 0.0;
  for (const Json& entry : document) {
    const double at_s = entry.at("at_s");
    const std::string field = place + "/" + std::to_string(recorded.messages.size()) + "/at_s";
    if (at_s < last_s)
      throw ScriptError(
          {"out-of-range", field, "no less than the time before it", entry.at("at_s").dump()});
    recorded.messages.push_back({at_s, entry.at("message")});
    last_s = at_s;
  }
  return recorded;
}

Motion parse_motion(const Json& document, const std::string& place) {
  const std::string kind = document.begin().key();
  const Json& parameters = document.begin().value();
  if (kind == "orbit") return Orbit{parameters.at("degrees_per_second")};
  if (kind == "inspect") return parse_inspect(parameters);
  if (kind == "drag_lens") return parse_drag_lens(parameters);
  if (kind == "zoom") return parse_zoom(parameters);
  if (kind == "recorded") return parse_recorded(parameters, place + "/recorded");
  return Idle{};
}

Segment parse_segment(const Json& document, const std::string& place) {
  Segment segment;
  take(document, "for_s", segment.for_s);
  take(document, "think_s", segment.think_s);
  if (segment.think_s[0] > segment.think_s[1])
    throw ScriptError({"out-of-range", place + "/think_s", "the shorter time before the longer one",
                       document.at("think_s").dump()});
  segment.motion = parse_motion(document.at("motion"), place + "/motion");
  return segment;
}

PictureSize parse_size(const Json& document) {
  return {.width_px = document.at("width_px"), .height_px = document.at("height_px")};
}

void take_link(const Json& document, LinkSettings& link) {
  if (!document.contains("link")) return;
  take(document.at("link"), "bytes_per_second", link.bytes_per_second);
  take(document.at("link"), "delay_ms", link.delay_ms);
}

void take_reading(const Json& document, std::optional<ReadingStop>& reading) {
  if (!document.contains("reading")) return;
  const Json& stop = document.at("reading");
  reading = ReadingStop{.stops_after_s = stop.at("stops_after_s"), .for_s = stop.at("for_s")};
}

Role parse_role(const Json& document, const std::string& place) {
  Role role;
  take(document, "name", role.name);
  take(document, "share", role.share);
  take(document, "inputs_per_second", role.inputs_per_second);
  role.viewport = parse_size(document.at("viewport"));
  for (const Json& segment : document.at("motion")) {
    const std::string number = std::to_string(role.motion.size());
    role.motion.push_back(parse_segment(segment, place + "/motion/" + number));
  }
  take_link(document, role.link);
  take_reading(document, role.reading);
  return role;
}

void take_roles(const Json& document, std::vector<Role>& roles) {
  std::set<std::string> names;
  for (const Json& role : document.at("roles")) {
    const std::string place = "/roles/" + std::to_string(roles.size());
    roles.push_back(parse_role(role, place));
    if (!names.insert(roles.back().name).second)
      throw ScriptError({"out-of-range", place + "/name", "a name that no other role has",
                         role.at("name").dump()});
  }
}

void take_thresholds(const Json& document, Thresholds& thresholds) {
  if (!document.contains("thresholds")) return;
  const Json& from = document.at("thresholds");
  take(from, "latency_p95_ms", thresholds.latency_p95_ms);
  take(from, "latency_growth_ms", thresholds.latency_growth_ms);
  take(from, "frames_per_second", thresholds.frames_per_second);
  take(from, "first_frame_s", thresholds.first_frame_s);
  take(from, "still_s", thresholds.still_s);
  take(from, "errors", thresholds.errors);
  take(from, "stale_frames", thresholds.stale_frames);
  take(from, "disconnects", thresholds.disconnects);
  take(from, "fairness", thresholds.fairness);
  take(from, "memory_growth_mib", thresholds.memory_growth_mib);
}

Json parse_text(const std::string& text) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw ScriptError({"malformed-json", "", "JSON", error.what()});
  } catch (const Json::out_of_range& error) {
    throw ScriptError({"not-finite", "", "numbers that a double holds", error.what()});
  }
}

}  // namespace

Script parse_script(const std::string& text) {
  const Json document = parse_text(text);
  check_script(document);
  Script script;
  take(document, "title", script.title);
  take(document, "description", script.description);
  take(document, "volume", script.volume);
  take(document, "style", script.style);
  take(document, "scene", script.scene);
  take(document, "clients", script.clients);
  take(document, "seconds", script.seconds);
  take(document, "ramp_s", script.ramp_s);
  take_roles(document, script.roles);
  take_thresholds(document, script.thresholds);
  return script;
}

Script read_script(const std::filesystem::path& file) {
  std::ostringstream text;
  const std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file) || !(text << stream.rdbuf()))
    throw std::runtime_error(file.string() + ": cannot be read");
  return parse_script(text.str());
}

std::vector<int> assign_roles(const std::vector<Role>& roles, int clients) {
  const double whole =
      std::accumulate(roles.begin(), roles.end(), 0.0,
                      [](double sum, const Role& role) { return sum + role.share; });
  std::vector<int> assigned;
  std::vector<int> counts(roles.size(), 0);
  for (int client = 0; client < clients; ++client) {
    // The role that lacks most of what is due to it by now.
    std::size_t chosen = 0;
    double most_due = -1e300;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const double due = roles[i].share / whole * (client + 1) - counts[i];
      if (due > most_due + 1e-9) {
        chosen = i;
        most_due = due;
      }
    }
    ++counts[chosen];
    assigned.push_back(static_cast<int>(chosen));
  }
  return assigned;
}

}  // namespace cutaway::load
