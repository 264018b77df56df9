// What one client saw. Times are seconds on the run's clock, which starts with the run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cutaway::load {

struct FrameSample {
  double at_s = 0.0;                ///< arrival
  std::optional<float> latency_ms;  ///< of an interactive frame that shows a new input
  float render_ms = 0.0F;           ///< the server's, from the header
  float encode_ms = 0.0F;           ///< the same
  std::uint32_t bytes = 0;
  bool still = false;
  bool moving = false;  ///< it arrived while the client moved something
};

struct StillSample {
  double at_s = 0.0;
  double after_s = 0.0;  ///< since the last input of the movement
};

struct Interval {
  double begin_s = 0.0;
  double end_s = 0.0;
};

struct Record {
  int role = 0;  ///< index into the script's roles
  std::optional<double> first_message_s;
  std::optional<double> first_frame_s;
  std::vector<FrameSample> frames;
  std::vector<StillSample> stills;
  std::vector<Interval> moving;
  std::vector<float> input_lag_ms;  ///< how late the client itself sent each input
  std::uint64_t text_bytes = 0;     ///< of text messages, whole run
  std::uint64_t stale_frames = 0;
  std::uint64_t errors = 0;
  std::vector<std::string> error_texts;  ///< the first few
  bool disconnected = false;
  std::string disconnect_reason;
  std::string server;    ///< from `capabilities`
  std::string renderer;  ///< from `capabilities`

  void note_error(const std::string& text) {
    constexpr std::size_t kKept = 5;
    ++errors;
    if (error_texts.size() < kKept) error_texts.push_back(text);
  }
};

}  // namespace cutaway::load
