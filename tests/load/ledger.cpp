#include "load/ledger.h"

namespace cutaway::load {

namespace {

// Numbers wrap around, so "before" is a matter of the shorter way round.
bool before(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) < 0; }

}  // namespace

void Ledger::moved(double at_s, double pause_s) {
  awaited_.reset();
  if (record_.moving.empty() || at_s > moving_until_s_) record_.moving.push_back({at_s, at_s});
  record_.moving.back().end_s = at_s;
  moving_until_s_ = at_s + pause_s;
}

void Ledger::rested(std::uint32_t input, double at_s) {
  awaited_ = Awaited{input, at_s};
  moving_until_s_ = at_s;
}

void Ledger::arrived(const FrameHeader& frame, std::size_t bytes, double at_s) {
  if (!record_.first_frame_s) record_.first_frame_s = at_s;
  FrameSample sample{.at_s = at_s,
                     .latency_ms = {},
                     .render_ms = 1e-3F * static_cast<float>(frame.render_us),
                     .encode_ms = 1e-3F * static_cast<float>(frame.encode_us),
                     .bytes = static_cast<std::uint32_t>(bytes),
                     .still = frame.still,
                     .moving = moving(at_s)};
  if (is_stale(frame)) ++record_.stale_frames;
  const bool news = !last_number_ || before(last_input_, frame.input);
  if (news && !frame.still) sample.latency_ms = static_cast<float>(1e3 * at_s - frame.clock_ms);
  settle_still(frame, at_s);
  record_.frames.push_back(sample);
  last_number_ = frame.number;
  last_input_ = frame.input;
}

bool Ledger::is_stale(const FrameHeader& frame) const {
  return last_number_ && (!before(*last_number_, frame.number) || before(frame.input, last_input_));
}

void Ledger::settle_still(const FrameHeader& frame, double at_s) {
  if (!awaited_ || !frame.still || before(frame.input, awaited_->input)) return;
  record_.stills.push_back({at_s, at_s - awaited_->since_s});
  awaited_.reset();
}

bool Ledger::moving(double at_s) const { return at_s <= moving_until_s_; }

}  // namespace cutaway::load
