#include "session/session.h"

#include <utility>

#include "core/log.h"
#include "scene/json_text.h"
#include "scene/styles.h"
#include "session/pick.h"

namespace cutaway {

namespace {

constexpr double kRefusalsPerSecond =
    1.0;  // `rate-limited` errors, so that they are no flood of their own
constexpr std::size_t kSmallMessageBytes =
    256;  // an acknowledgement is smaller; it passes any rate limit
constexpr Milliseconds kBetweenScenes{50.0};  // `scene` messages to the client

Error no_volume() {
  return Error({.code = "no-volume",
                .message = "no scene is shown yet",
                .expected = "an open volume and a viewport first"});
}

Error too_wide(const char* field, int most, int received) {
  return Error({.code = "out-of-range",
                .message = "the picture is too large",
                .field = field,
                .expected = fmt::format("1 to {} px", most),
                .received = std::to_string(received)});
}

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

// Past the rate only acknowledgements are heeded: refusing one would leave its credit out for ever.
Session::Reception Session::receive_text(std::string_view text) {
  const bool too_fast = !message_rate_.take(ends_.strand->now());
  if (too_fast && text.size() > kSmallMessageBytes) return refuse_too_fast();
  try {
    const ClientMessage message = parse_client_message(text);
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
  return Reception::taken;
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

void Session::handle(const SceneMessage& message) {
  const auto wanted = volume_of(message.scene);
  const bool wants_shown = wanted && state_.volume() && *wanted == state_.volume()->facts().id;
  if (wanted && !wants_shown && wanted != opening_.volume()) {
    const Json base =
        state_.volume() ? without_volume_dependent(state_.document()) : state_.document();
    return open_volume(*wanted, changed_document(base, message.scene, message.replace),
                       message.stamp);
  }
  if (wanted && !wants_shown) {
    pending_->document = changed_document(pending_->document, message.scene, message.replace);
    pending_->stamp = message.stamp;
    return;
  }
  change_shown(message);
  if (wants_shown) stop_opening();
}

// What changes while another volume is on its way holds for that one too.
void Session::change_shown(const SceneMessage& message) {
  std::optional<Json> awaited;
  if (pending_) {
    awaited = changed_document(pending_->document, message.scene, message.replace);
  }
  const Json shown = changed_document(state_.document(), message.scene, message.replace);
  took_effect(state_.set_document(shown), message.stamp);
  if (awaited) pending_->document = std::move(*awaited);
}

void Session::handle(const ViewportMessage& message) {
  check_size(message.width_px, message.height_px);
  took_effect(state_.set_viewport({message.width_px, message.height_px}), message.stamp);
}

void Session::handle(const DragLensMessage& message) {
  const glm::dvec3 centre =
      dragged_lens_centre(shown_scene(), *state_.volume(), message.position_px);
  const Json patch = {{"lens", {{"centre_mm", {centre.x, centre.y, centre.z}}}}};
  const Json document = changed_document(state_.document(), patch, false);
  took_effect(state_.set_document(document), message.stamp);
  tell_scene_soon();
}

void Session::handle(const PickMessage& message) {
  const auto hit = pick(shown_scene(), *state_.volume(), message.position_px);
  std::optional<PickedPoint> point;
  if (hit) {
    point =
        PickedPoint{.position_mm = hit->position_mm,
                    .value = state_.volume()->value_at(hit->position_mm).value_or(hit->limit_value),
                    .units = state_.volume()->units(),
                    .branch = hit->branch};
  }
  tell(picked_message(message.request, point));
}

void Session::handle(const CancelLoadMessage&) { stop_opening(); }

void Session::handle(const AckMessage& message) { flow_.acknowledge(message.frame); }

void Session::handle(const SaveStillMessage& message) {
  check_size(message.width_px, message.height_px);
  shown_scene();
  stills_.save({message.request, {message.width_px, message.height_px}}, snapshot(),
               still_quality(settings_));
}

void Session::handle(const PreviewMessage& message) {
  style(message.style);  // refused now where there is none
  previews_.want(message);
}

void Session::open_volume(const std::string& id, Json document, InputStamp stamp) {
  stop_opening();
  pending_ = Pending{.volume = id, .document = std::move(document), .stamp = stamp};
  opening_.begin(id);
}

void Session::stop_opening() {
  if (!pending_) return;
  const Pending given_up = *std::exchange(pending_, std::nullopt);
  opening_.withdraw();
  tell(loading_message(given_up.volume, LoadEnd::cancelled));
}

void Session::opened(OpenOutcome outcome) {
  const Pending pending = *std::exchange(pending_, std::nullopt);
  if (auto* volume = std::get_if<std::shared_ptr<const OpenVolume>>(&outcome)) {
    try {
      show_opened(std::move(*volume), pending);
    } catch (const Error& error) {
      opening_failed(error, pending);
    }
  } else if (const auto* error = std::get_if<Error>(&outcome)) {
    opening_failed(*error, pending);
  } else {
    tell(loading_message(pending.volume, LoadEnd::cancelled));
  }
}

void Session::opening_failed(const Error& error, const Pending& pending) {
  refuse(error, {.input = pending.stamp.input, .request = {}});
  tell(loading_message(pending.volume, LoadEnd::failed));
}

void Session::show_opened(std::shared_ptr<const OpenVolume> volume, const Pending& pending) {
  const SceneState::Change change = state_.set_volume(std::move(volume), pending.document);
  tell(loading_message(pending.volume, LoadEnd::ready));
  took_effect({.picture = change.picture, .chosen = false}, pending.stamp);
  if (change.picture) tell_scene();  // whether or not anything was chosen
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

const Scene& Session::shown_scene() const {
  if (!state_.scene()) throw no_volume();
  return *state_.scene();
}

void Session::check_size(int width_px, int height_px) const {
  const int most = settings_.viewport_side_px;
  if (width_px > most) throw too_wide("/width_px", most, width_px);
  if (height_px > most) throw too_wide("/height_px", most, height_px);
  const std::int64_t pixels = std::int64_t{width_px} * height_px;
  if (pixels <= settings_.viewport_pixels) return;
  throw Error(
      {.code = "out-of-range",
       .message = "the picture has too many pixels",
       .field = "/width_px",
       .expected = fmt::format("width_px times height_px at most {}", settings_.viewport_pixels),
       .received = fmt::format("{} x {} = {}", width_px, height_px, pixels)});
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
  tell(scene_message(state_.revision(), *state_.scene(), state_.volume()->summary()));
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
