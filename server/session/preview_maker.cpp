#include "session/preview_maker.h"

#include <utility>

#include "scene/json_text.h"
#include "session/frame_message.h"

namespace cutaway {

namespace {

constexpr std::size_t kMostWaiting = 64;

FrameQuality preview_quality() {
  FrameQuality quality;
  quality.supersampling = 2;
  quality.still = true;
  return quality;
}

/// All that a picture of a whole volume depends on; nothing where it is no one else's wish.
std::optional<std::string> cache_key(const PreviewMessage& wish) {
  if (!wish.volume || !wish.scene.empty()) return {};
  return json_text(
      Json::array({*wish.volume, wish.style.value_or(""), wish.width_px, wish.height_px}));
}

Viewport viewport_of(const PreviewMessage& wish) { return {wish.width_px, wish.height_px}; }

}  // namespace

PreviewMaker::PreviewMaker(Wiring wiring, Hooks hooks)
    : wiring_(std::move(wiring)), hooks_(std::move(hooks)), callbacks_(wiring_.strand) {}

PreviewMaker::~PreviewMaker() { wiring_.source.release(wiring_.view.view); }

void PreviewMaker::want(const PreviewMessage& wish) {
  if (waiting_.size() >= kMostWaiting) {
    throw Error({.code = ErrorCode::rate_limited,
                 .message = "too many previews wait",
                 .expected = "at most " + std::to_string(kMostWaiting) + " at a time"});
  }
  waiting_.push_back(wish);
  if (!busy_) make_next();
}

void PreviewMaker::make_next() {
  busy_ = !waiting_.empty();
  if (!busy_) return wiring_.source.release(wiring_.view.view);
  const PreviewMessage wish = std::move(waiting_.front());
  waiting_.pop_front();
  begin(wish);
}

void PreviewMaker::begin(const PreviewMessage& wish) {
  if (!wish.volume) return render(wish);
  const auto key = cache_key(wish);
  if (const auto kept = key ? wiring_.cache.find(*key) : nullptr) return send(wish, {}, *kept);
  open(wish);
}

void PreviewMaker::open(const PreviewMessage& wish) {
  ticket_ = wiring_.volumes.open_for_preview(
      *wish.volume, callbacks_.bind<OpenOutcome>(
                        [this, wish](OpenOutcome outcome) { opened(wish, std::move(outcome)); }));
}

void PreviewMaker::opened(const PreviewMessage& wish, OpenOutcome outcome) {
  ticket_.reset();
  if (const auto* error = std::get_if<Error>(&outcome)) return fail(wish, *error);
  if (std::holds_alternative<Cancelled>(outcome)) return fail(wish, picture_given_up());
  other_ = std::move(std::get<std::shared_ptr<const OpenVolume>>(outcome));
  render(wish);
}

void PreviewMaker::render(const PreviewMessage& wish) {
  try {
    const SceneSnapshot shown = hooks_.scene(wish, other_.get());
    wiring_.source.submit({.view = wiring_.view.view,
                           .share = wiring_.view.share,
                           .session = wiring_.view.session,
                           .revision = shown.revision,
                           .scene = shown.scene,
                           .quality = preview_quality()},
                          callbacks_.bind<FrameOutcome>([this, wish, shown](FrameOutcome outcome) {
                            came_back(wish, shown, std::move(outcome));
                          }));
  } catch (const Error& error) {
    fail(wish, error);
  }
}

void PreviewMaker::came_back(const PreviewMessage& wish, const SceneSnapshot& shown,
                             FrameOutcome outcome) {
  auto* frame = std::get_if<Frame>(&outcome);
  if (frame == nullptr) {
    const auto* error = std::get_if<Error>(&outcome);
    return fail(wish, error != nullptr ? *error : picture_given_up());
  }
  const auto made = std::make_shared<const Frame>(std::move(*frame));
  if (const auto key = cache_key(wish)) wiring_.cache.put(*key, made);
  send(wish, shown.stamp, *made);
}

void PreviewMaker::send(const PreviewMessage& wish, const InputStamp& stamp, const Frame& frame) {
  other_.reset();
  wiring_.sink.send_still(preview_message(wish.request, stamp, viewport_of(wish), frame),
                          callbacks_.bind<bool>([this](bool) { ended(); }));
}

void PreviewMaker::fail(const PreviewMessage& wish, const Error& error) {
  hooks_.failed(wish.request, error);
  ended();
}

void PreviewMaker::ended() {
  other_.reset();
  make_next();
}

}  // namespace cutaway
