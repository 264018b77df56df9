// A load script: what the clients do (protocol/schema/load-script.schema.json has every field's
// meaning, unit and range).
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cutaway::load {

using Json = nlohmann::json;

struct Orbit {
  double degrees_per_second = 0.0;
};
struct Inspect {
  double swing_degrees = 6.0;
  double move_s = 1.0;
  double pause_s = 1.0;
};
struct DragLens {
  std::array<double, 2> centre = {0.5, 0.5};  ///< fractions of the viewport's width and height
  double radius = 0.2;                        ///< fraction of its shorter side
  double turns_per_second = 0.25;
};
struct Zoom {
  double nearest = 0.5;  ///< share of the first distance
  double period_s = 4.0;
};
struct Idle {};
struct RecordedMessage {
  double at_s = 0.0;
  Json message;  ///< without `input` and `clock_ms`
};
struct Recorded {
  std::vector<RecordedMessage> messages;
};
using Motion = std::variant<Orbit, Inspect, DragLens, Zoom, Idle, Recorded>;

struct Segment {
  double for_s = 0.0;
  std::array<double, 2> think_s = {0.0, 0.0};  ///< least and most
  Motion motion;
};

struct PictureSize {
  int width_px = 0;
  int height_px = 0;
};

struct LinkSettings {
  std::int64_t bytes_per_second = 0;  ///< 0: without a limit
  double delay_ms = 0.0;              ///< each way
};

struct ReadingStop {
  double stops_after_s = 0.0;  ///< from when the client's scene is open
  double for_s = 0.0;
};

struct Role {
  std::string name;
  double share = 1.0;
  PictureSize viewport;
  double inputs_per_second = 60.0;
  std::vector<Segment> motion;
  LinkSettings link;
  std::optional<ReadingStop> reading;

  /// Thresholds on speed and fairness hold for it.
  bool judged() const { return !reading; }
};

/// The most (of frames_per_second the least) that may be measured; nothing: not judged.
struct Thresholds {
  std::optional<double> latency_p95_ms;
  std::optional<double> latency_growth_ms;
  std::optional<double> frames_per_second;
  std::optional<double> first_frame_s;
  std::optional<double> still_s;
  std::int64_t errors = 0;
  std::int64_t stale_frames = 0;
  std::int64_t disconnects = 0;
  std::optional<double> fairness;
  std::optional<double> memory_growth_mib;
};

struct Script {
  std::string title;
  std::string description;
  std::string volume;
  std::string style;
  Json scene = Json::object();
  int clients = 1;
  double seconds = 30.0;
  double ramp_s = 0.0;
  std::vector<Role> roles;
  Thresholds thresholds;
};

/// Throws ScriptError.
Script parse_script(const std::string& text);
/// Throws ScriptError, and std::runtime_error for a file that cannot be read.
Script read_script(const std::filesystem::path& file);

/// The role of each client, by index into `roles`: as near to the shares as whole clients can be,
/// and well mixed.
std::vector<int> assign_roles(const std::vector<Role>& roles, int clients);

}  // namespace cutaway::load
