#include "session/session.h"

#include <fmt/format.h>

#include <utility>

#include "core/log.h"
#include "scene/first_look.h"
#include "scene/json_text.h"
#include "scene/styles.h"

namespace cutaway {

namespace {

constexpr double kRefusalsPerSecond =
    1.0;  // `rate-limited` errors, so that they are no flood of their own
constexpr std::size_t kSmallMessageBytes =
    256;  // an acknowledgement is smaller; it passes any rate limit
constexpr Milliseconds kBetweenScenes{50.0};  // `scene` messages to the client

/// A patch that is not taken up can change all but the volume, which would have to be opened.
const Json& for_one_picture(const Json& patch) {
  if (!patch.contains("volume")) return patch;
  throw Error({.code = ErrorCode::invalid_scene,
               .message = "a picture's patch cannot name a volume",
               .field = "/volume",
               .expected = "another field of a scene",
               .received = json_text(patch.at("volume"))});
}

}  // namespace

Session::Session(SessionWiring wiring, const SessionSettings& settings)
    : wiring_(std::move(wiring)),
      settings_(settings),
      message_rate_(settings.messages, wiring_.strand->now()),
      refusal_rate_({.per_second = kRefusalsPerSecond, .burst = 1.0}, wiring_.strand->now()),
      stills_(wiring_.strand, wiring_.frames, wiring_.client, render_view(wiring_.still_view),
              [this](std::uint32_t request, const Error& error) {
                refuse(error, {.input = {}, .request = request});
              }),
      previews_(preview_wiring(wiring_.preview_view), preview_hooks()),
      volume_previews_(preview_wiring(wiring_.volume_preview_view), preview_hooks()),
      unseen_(wiring_.strand,
              [this](const std::vector<UnseenReason>& reasons) { tell(unseen_message(reasons)); }),
      opening_(wiring_.strand, wiring_.volumes,
               {.progress =
                    [this](LoadStage stage, double fraction) {
                      tell(loading_message(pending_->volume, stage, fraction));
                    },
                .finished = [this](OpenOutcome outcome) { opened(std::move(outcome)); }}),
      scene_alarm_(wiring_.strand->make_alarm([this] { tell_scene(); })),
      callbacks_(wiring_.strand) {
  for (std::size_t view = 0; view < flows_.size(); ++view) {
    const ViewWiring of_view{.source = wiring_.frames,
                             .sink = wiring_.client,
                             .link = link_,
                             .view = render_view(wiring_.live_views[view]),
                             .kind = static_cast<ViewKind>(view)};
    flows_[view] = std::make_unique<FrameFlow>(wiring_.strand, of_view, settings,
                                               [this](const Error& error) { refuse(error, {}); });
  }
}

// The session's share goes by the name of its first view.
RenderView Session::render_view(std::uint64_t view) const {
  return {view, wiring_.live_views.front(), wiring_.name};
}

PreviewMaker::Wiring Session::preview_wiring(std::uint64_t view) const {
  return {.strand = wiring_.strand,
          .source = wiring_.frames,
          .volumes = wiring_.volumes,
          .sink = wiring_.client,
          .cache = wiring_.previews,
          .view = render_view(view)};
}

PreviewMaker::Hooks Session::preview_hooks() {
  return {
      .scene = [this](const PreviewMessage& wish,
                      const OpenVolume* other) { return preview_of(wish, other); },
      .failed = [this](std::uint32_t request,
                       const Error& error) { refuse(error, {.input = {}, .request = request}); }};
}

void Session::start() {
  wiring_.client.send_text(*wiring_.capabilities);
  tell_volumes();
  listing_watch_ = wiring_.volumes.watch(
      [changed = callbacks_.bind<int>([this](int) { tell_volumes(); })] { changed(0); });
}

Session::Reception Session::receive_binary() {
  if (!message_rate_.take(wiring_.strand->now())) return refuse_too_fast();
  refuse(binary_message_error(), {});
  return Reception::taken;
}

Session::Reception Session::receive_too_large(std::size_t bytes, std::size_t most) {
  if (!message_rate_.take(wiring_.strand->now())) return refuse_too_fast();
  refuse(Error({.code = ErrorCode::too_large,
                .message = "the message is too large; it was not heeded",
                .expected = fmt::format("at most {} bytes", most),
                .received = fmt::format("{} bytes", bytes)}),
         {});
  return Reception::taken;
}

// Past the rate only acknowledgements are heeded: refusing one would leave its credit out for ever.
Session::Reception Session::receive_text(std::string_view text) {
  const bool too_fast = !message_rate_.take(wiring_.strand->now());
  if (too_fast && text.size() > kSmallMessageBytes) return refuse_too_fast();
  try {
    const ClientMessage message = parse_client_message(
        text, {.viewport_px = settings_.viewport_side_px, .still_px = settings_.still_side_px});
    if (too_fast && !std::holds_alternative<AckMessage>(message)) return refuse_too_fast();
    std::visit([this](const auto& each) { handle(each); }, message);
  } catch (const Error& error) {
    if (too_fast) return refuse_too_fast();
    refuse(error, echo_of(text));
  } catch (const std::exception& failure) {
    log().error("{}: a message failed: {}", wiring_.name, failure.what());
    refuse(Error({.code = ErrorCode::internal, .message = "the server failed at this message"}),
           echo_of(text));
  }
  pay_for_lens_searches();
  return Reception::taken;
}

// Paid for afterwards, since only then it is known whether the memory had the answer. Pictures
// beside the scene, which are made at the server's pace, leave half of the burst: a list of volumes
// with their pictures must not cost the user the next click.
void Session::pay_for_lens_searches() {
  const TimePoint now = wiring_.strand->now();
  const double cost = settings_.lens_search_messages;
  message_rate_.charge(now, state_.take_lens_searches() * cost);
  message_rate_.charge_above(now, lenses_of_pictures_.take_searches() * cost,
                             settings_.messages.burst / 2.0);
}

Session::Reception Session::refuse_too_fast() {
  if (refusal_rate_.take(wiring_.strand->now())) {
    refuse(Error({.code = ErrorCode::rate_limited,
                  .message = "messages come too fast; some were not heeded",
                  .expected = fmt::format("{} a second", settings_.messages.per_second)}),
           {});
  }
  return Reception::too_fast;
}

void Session::took_effect(SceneState::Change change, InputStamp stamp) {
  stamp_ = stamp;
  prepare_shown();
  if (change.chosen) tell_scene_soon();
  if (change.pictures[std::size_t(ViewKind::volume)])
    unseen_.changed(state_.scene(), state_.volume());
  for (std::size_t view = 0; view < flows_.size(); ++view) {
    if (change.pictures[view]) {
      flows_[view]->show(snapshot(static_cast<ViewKind>(view)));
    } else {
      flows_[view]->restamp(stamp);
    }
  }
}

namespace {

bool want_the_same_volume(const Scene& a, const Scene& b) {
  return a.volume == b.volume && a.preparation == b.preparation &&
         a.context.surface.band == b.context.surface.band &&
         a.focus.surface.band == b.focus.surface.band;
}

}  // namespace

// Until it is ready, frames show the volume as near to it as there is.
void Session::prepare_shown() {
  const auto& scene = state_.scene();
  if (!scene || (prepared_for_ && want_the_same_volume(*prepared_for_, *scene))) return;
  prepared_for_ = *scene;
  preparing_ = wiring_.volumes.prepare(*scene, [ready = callbacks_.bind<int>([this](int) {
    preparing_.reset();
    flow(ViewKind::volume).show(snapshot(ViewKind::volume));
  })] { ready(0); });
}

// Drags change the scene at the rate of the pointer; the client needs to hear of it at that of the
// eye.
void Session::tell_scene_soon() {
  const TimePoint now = wiring_.strand->now();
  if (!scene_told_at_ || now - *scene_told_at_ >= kBetweenScenes) return tell_scene();
  scene_alarm_->set(*scene_told_at_ + std::chrono::ceil<SessionClock::duration>(kBetweenScenes));
}

void Session::tell_scene() {
  if (!state_.scene()) return;
  scene_alarm_->clear();
  scene_told_at_ = wiring_.strand->now();
  if (told_volume_ == state_.volume()) {
    return wiring_.client.send_latest_text(
        json_text(scene_message(state_.revision(), stamp_.input, *state_.scene())));
  }
  told_volume_ = state_.volume();
  tell(scene_message(state_.revision(), stamp_.input, *state_.scene(), told_volume_->summary()));
}

void Session::tell_volumes() { tell(volumes_message(wiring_.volumes.listing())); }

void Session::refuse(const Error& error, const MessageEcho& echo) {
  tell(error_message(error, echo));
}

void Session::tell(const Json& message) { wiring_.client.send_text(json_text(message)); }

SceneSnapshot Session::preview_of(const PreviewMessage& wish, const OpenVolume* other) {
  const bool is_own = other == nullptr;
  if (is_own) shown_scene();
  const OpenVolume& volume = is_own ? *state_.volume() : *other;
  Json document = is_own ? state_.document() : Json::object();
  if (wish.style) document = changed_document(document, style(*wish.style).scene, false);
  document = changed_document(document, for_one_picture(wish.scene), false);
  document = with_first_look(std::move(document), volume.facts());
  Scene scene =
      resolve_scene(document, volume.facts(), {wish.width_px, wish.height_px}, lenses_of_pictures_);
  pay_for_lens_searches();
  return {.scene = std::make_shared<const Scene>(std::move(scene)),
          .revision = is_own ? state_.revision() : 0,
          .stamp = is_own ? stamp_ : InputStamp{}};
}

SceneSnapshot Session::still_of(const SaveStillMessage& wish) {
  shown_scene(wish.view);
  const Json document = changed_document(state_.document(), for_one_picture(wish.scene), false);
  Scene scene = resolve_scene(document, state_.volume()->facts(), shown_scene().viewport,
                              lenses_of_pictures_);
  scene.viewport = {wish.width_px, wish.height_px, wish.view};
  return {.scene = std::make_shared<const Scene>(std::move(scene)),
          .revision = state_.revision(),
          .stamp = stamp_};
}

SceneSnapshot Session::snapshot(ViewKind view) const {
  return {.scene = state_.scene(view), .revision = state_.revision(), .stamp = stamp_};
}

}  // namespace cutaway
