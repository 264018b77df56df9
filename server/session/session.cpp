#include "session/session.h"

#include <fmt/format.h>

#include <utility>

#include "core/log.h"
#include "scene/json_text.h"
#include "scene/styles.h"

namespace cutaway {

namespace {

constexpr double kRefusalsPerSecond =
    1.0;  // `rate-limited` errors, so that they are no flood of their own
constexpr std::size_t kSmallMessageBytes =
    256;  // an acknowledgement is smaller; it passes any rate limit
constexpr Milliseconds kBetweenScenes{50.0};  // `scene` messages to the client

}  // namespace

Session::Session(SessionEnds ends, const SessionSettings& settings)
    : ends_(std::move(ends)),
      settings_(settings),
      message_rate_(settings.messages_per_second, settings.message_burst, ends_.strand->now()),
      refusal_rate_(kRefusalsPerSecond, 1.0, ends_.strand->now()),
      flow_(ends_.strand, ends_.frames, ends_.client, ends_.live_view, settings,
            [this](const Error& error) { refuse(error, {}); }),
      stills_(ends_.strand, ends_.frames, ends_.client, ends_.still_view,
              [this](std::uint32_t request, const Error& error) {
                refuse(error, {.input = {}, .request = request});
              }),
      previews_(ends_.strand, ends_.frames, ends_.client, ends_.preview_view,
                {.scene = [this](const PreviewMessage& wish) { return in_style(wish); },
                 .failed =
                     [this](std::uint32_t request, const Error& error) {
                       refuse(error, {.input = {}, .request = request});
                     }}),
      opening_(ends_.strand, ends_.volumes,
               {.progress =
                    [this](LoadStage stage, double fraction) {
                      tell(loading_message(pending_->volume, stage, fraction));
                    },
                .finished = [this](OpenOutcome outcome) { opened(std::move(outcome)); }}),
      scene_alarm_(ends_.strand->make_alarm([this] { tell_scene(); })),
      tether_(ends_.strand) {}

void Session::start() {
  ends_.client.send_text(*ends_.capabilities);
  tell_volumes();
  listing_watch_ = ends_.volumes.watch(
      [changed = tether_.bind<int>([this](int) { tell_volumes(); })] { changed(0); });
}

Session::Reception Session::receive_binary() {
  if (!message_rate_.take(ends_.strand->now())) return refuse_too_fast();
  refuse(binary_message_error(), {});
  return Reception::taken;
}

Session::Reception Session::receive_too_large(std::size_t bytes, std::size_t most) {
  if (!message_rate_.take(ends_.strand->now())) return refuse_too_fast();
  refuse(Error({.code = "too-large",
                .message = "the message is too large; it was not heeded",
                .expected = fmt::format("at most {} bytes", most),
                .received = fmt::format("{} bytes", bytes)}),
         {});
  return Reception::taken;
}

// Past the rate only acknowledgements are heeded: refusing one would leave its credit out for ever.
Session::Reception Session::receive_text(std::string_view text) {
  const bool too_fast = !message_rate_.take(ends_.strand->now());
  if (too_fast && text.size() > kSmallMessageBytes) return refuse_too_fast();
  try {
    const ClientMessage message = parse_client_message(text, settings_.viewport_side_px);
    if (too_fast && !std::holds_alternative<AckMessage>(message)) return refuse_too_fast();
    std::visit([this](const auto& each) { handle(each); }, message);
  } catch (const Error& error) {
    if (too_fast) return refuse_too_fast();
    refuse(error, echo_of(text));
  } catch (const std::exception& failure) {
    log().error("a client's message failed: {}", failure.what());
    refuse(Error({.code = "internal", .message = "the server failed at this message"}),
           echo_of(text));
  }
  pay_for_lens_searches();
  return Reception::taken;
}

// Paid for afterwards, since only then it is known whether the memory had the answer.
void Session::pay_for_lens_searches() {
  const int searches = state_.take_lens_searches();
  if (searches == 0) return;
  message_rate_.charge(ends_.strand->now(), searches * settings_.lens_search_messages);
}

Session::Reception Session::refuse_too_fast() {
  if (refusal_rate_.take(ends_.strand->now())) {
    refuse(Error({.code = "rate-limited",
                  .message = "messages come too fast; some were not heeded",
                  .expected = fmt::format("{} a second", settings_.messages_per_second)}),
           {});
  }
  return Reception::too_fast;
}

void Session::took_effect(SceneState::Change change, InputStamp stamp) {
  stamp_ = stamp;
  if (change.chosen) tell_scene_soon();
  if (change.picture) {
    flow_.show(snapshot());
  } else {
    flow_.restamp(stamp);
  }
}

// Drags change the scene at the rate of the pointer; the client needs to hear of it at that of the
// eye.
void Session::tell_scene_soon() {
  const TimePoint now = ends_.strand->now();
  if (!scene_told_at_ || now - *scene_told_at_ >= kBetweenScenes) return tell_scene();
  scene_alarm_->set(*scene_told_at_ + std::chrono::ceil<SessionClock::duration>(kBetweenScenes));
}

void Session::tell_scene() {
  if (!state_.scene()) return;
  scene_alarm_->clear();
  scene_told_at_ = ends_.strand->now();
  if (told_volume_ == state_.volume()) {
    return ends_.client.send_latest_text(
        json_text(scene_message(state_.revision(), *state_.scene())));
  }
  told_volume_ = state_.volume();
  tell(scene_message(state_.revision(), *state_.scene(), told_volume_->summary()));
}

void Session::tell_volumes() { tell(volumes_message(ends_.volumes.listing())); }

void Session::refuse(const Error& error, const MessageEcho& echo) {
  tell(error_message(error, echo));
}

void Session::tell(const Json& message) { ends_.client.send_text(json_text(message)); }

SceneSnapshot Session::in_style(const PreviewMessage& wish) const {
  shown_scene();
  const Json document = changed_document(state_.document(), style(wish.style).scene, false);
  auto scene = std::make_shared<const Scene>(
      resolve_scene(document, state_.volume()->facts(), {wish.width_px, wish.height_px}));
  return {.scene = std::move(scene), .revision = state_.revision(), .stamp = stamp_};
}

SceneSnapshot Session::snapshot() const {
  return {.scene = state_.scene(), .revision = state_.revision(), .stamp = stamp_};
}

}  // namespace cutaway
