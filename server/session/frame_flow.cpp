#include "session/frame_flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/check.h"

namespace cutaway {

namespace {

// Numbers wrap around, so "not after" is a matter of the shorter way round.
bool at_or_before(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::int32_t>(a - b) <= 0;
}

bool draws_light(const Scene& scene) {
  return std::ranges::any_of(std::array{&scene.context, &scene.focus}, [](const Branch* branch) {
    return branch->occlusion.strength > 0.0 || branch->shadow.strength > 0.0;
  });
}

Error not_awaited(std::uint32_t frame, const std::string& awaited) {
  return Error({.code = ErrorCode::out_of_range,
                .message = "no acknowledgement of this frame is awaited",
                .field = "/frame",
                .expected = awaited,
                .received = std::to_string(frame)});
}

}  // namespace

FrameFlow::FrameFlow(const std::shared_ptr<Strand>& strand, const ViewWiring& wiring,
                     const SessionSettings& settings, std::function<void(const Error&)> failed)
    : strand_(strand),
      wiring_(wiring),
      failed_(std::move(failed)),
      credits_(settings.frames_in_flight),
      pacer_(settings.rest),
      quality_(settings),
      alarm_(strand->make_alarm([this] { pump(); })),
      callbacks_(strand) {}

FrameFlow::~FrameFlow() { wiring_.source.release(wiring_.view.view); }

void FrameFlow::show(SceneSnapshot snapshot) {
  if (newest_.scene && newest_.scene->volume != snapshot.scene->volume) quality_.forget_rays();
  newest_ = std::move(snapshot);
  pacer_.changed(strand_->now(), has_finish(*newest_.scene));
  pump();
}

void FrameFlow::hide() {
  newest_ = {};
  for (const Sent& sent : std::exchange(sent_, {})) {
    wiring_.link.arrived(sent.bytes);
    credits_.give_back();
  }
  if (last_number_ > 0) hidden_ = last_number_;
  pacer_.give_up();
  alarm_->clear();
  wiring_.source.release(wiring_.view.view);
}

void FrameFlow::acknowledge(std::uint32_t frame) {
  if (hidden_ && at_or_before(frame, *hidden_)) return;
  check_awaited(frame);
  acknowledged_ = frame;
  while (!sent_.empty() && at_or_before(sent_.front().number, frame)) {
    const Sent sent = sent_.front();
    if (sent.number == frame) measure(sent);
    sent_.pop_front();
    wiring_.link.arrived(sent.bytes);
    credits_.give_back();
  }
  pump();
}

// Saying the last one again does no harm; anything else is a client that counts wrongly.
void FrameFlow::check_awaited(std::uint32_t frame) const {
  if (acknowledged_ == frame) return;
  if (sent_.empty()) throw not_awaited(frame, "none before another frame is sent");
  const std::uint32_t first = sent_.front().number;
  if (frame - first <= last_number_ - first) return;  // numbers wrap around
  throw not_awaited(frame, fmt::format("{} to {}", first, last_number_));
}

void FrameFlow::measure(const Sent& sent) {
  const Milliseconds round_trip = strand_->now() - sent.at;
  quality_.acknowledged(sent.quality, sent.bytes, sent.bytes_in_flight, round_trip);
  pacer_.set_interval(quality_.interval());
}

// A request that still waits takes up the newest scene even before another frame is due: it costs
// nothing.
void FrameFlow::pump() {
  const TimePoint now = strand_->now();
  const bool due = pacer_.due(now).has_value();
  if (due || pacer_.has_change()) {
    const FrameKind kind = pacer_.kind(now);
    if (!is_early(kind) && (renew(kind) || (due && ask(kind)))) pacer_.asked(kind, now);
  }
  const std::optional<TimePoint> next = pacer_.next_due(now);
  if (next) {
    alarm_->set(*next);
  } else {
    alarm_->clear();
  }
}

// How many rays a still may have is known once the first frame is back, and as views are drawn one
// frame at a time, it would wait for that anyway.
bool FrameFlow::is_early(FrameKind kind) const {
  if (kind == FrameKind::finished) return !asked_.empty();  // it would replace the still
  return kind == FrameKind::still && wiring_.kind == ViewKind::volume && !asked_.empty() &&
         !quality_.knows_rays();
}

bool FrameFlow::renew(FrameKind kind) {
  if (asked_.empty() || !wiring_.source.renew(request(kind))) return false;
  asked_.back().snapshot = newest_;
  return true;
}

bool FrameFlow::ask(FrameKind kind) {
  if (!credits_.take()) return false;
  const std::uint64_t id = ++last_id_;
  asked_.push_back({id, newest_});
  wiring_.source.submit(
      request(kind), callbacks_.bind<FrameOutcome>(
                         [this, id](FrameOutcome outcome) { came_back(id, std::move(outcome)); }));
  return true;
}

// A device that computes light in no time has it in the still already.
bool FrameFlow::has_finish(const Scene& scene) const {
  return wiring_.kind == ViewKind::volume && draws_light(scene) &&
         wiring_.source.describe().software;
}

FrameQuality FrameFlow::quality_of(FrameKind kind) const {
  if (kind == FrameKind::interactive) return quality_.interactive();
  FrameQuality quality = quality_.still(newest_.scene->viewport);
  if (kind == FrameKind::still && has_finish(*newest_.scene)) quality.light = LightDetail::quick;
  return quality;
}

FrameRequest FrameFlow::request(FrameKind kind) const {
  return {.view = wiring_.view.view,
          .share = wiring_.view.share,
          .session = wiring_.view.session,
          .revision = newest_.revision,
          .scene = newest_.scene,
          .quality = quality_of(kind)};
}

void FrameFlow::came_back(std::uint64_t id, FrameOutcome outcome) {
  const auto asked = std::ranges::find(asked_, id, &Asked::id);
  check(asked != asked_.end(), "a frame comes back once");
  const SceneSnapshot shown = std::move(asked->snapshot);
  asked_.erase(asked);
  auto* frame = std::get_if<Frame>(&outcome);
  // Frames are compressed side by side: one that a newer has overtaken would show the past.
  const bool is_overtaken = id < last_sent_id_;
  const bool is_hidden = newest_.scene == nullptr;
  if (frame != nullptr && !is_overtaken && !is_hidden) {
    last_sent_id_ = id;
    send(shown, *frame);
  } else {
    credits_.give_back();
    if (const auto* error = std::get_if<Error>(&outcome)) fail(shown, *error);
  }
  pump();
}

void FrameFlow::fail(const SceneSnapshot& shown, const Error& error) {
  if (shown.revision == newest_.revision) pacer_.give_up();
  failed_(error);
}

void FrameFlow::send(const SceneSnapshot& shown, const Frame& frame) {
  const std::chrono::microseconds cost(std::uint64_t{frame.render_us} + frame.encode_us);
  quality_.rendered(frame.quality, cost);
  if (frame.cast_rays && shown.scene->volume == newest_.scene->volume)
    quality_.cast_rays(frame.quality, shown.scene->viewport,
                       std::chrono::microseconds(frame.render_us));
  const std::uint32_t number = ++last_number_;
  const std::size_t bytes = frame.picture.bytes.size();
  wiring_.link.sent(bytes);
  sent_.push_back({number, frame.quality, bytes, wiring_.link.bytes_in_flight(), strand_->now()});
  std::vector<std::uint8_t> message =
      live_frame_message(number, shown.stamp, shown.scene->viewport, frame);
  wiring_.sink.send_frame(
      wiring_.kind, std::move(message),
      callbacks_.bind<bool>([this, number](bool sent) { written(number, sent); }));
}

void FrameFlow::written(std::uint32_t number, bool sent) {
  if (sent) return;
  const auto lost = std::ranges::find(sent_, number, &Sent::number);
  if (lost == sent_.end()) return;
  wiring_.link.arrived(lost->bytes);
  sent_.erase(lost);
  credits_.give_back();
  pump();
}

}  // namespace cutaway
