#include "session/preview_maker.h"

#include <utility>

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

Error given_up() {
  return Error({.code = "render-failed", .message = "the preview was given up by the renderer"});
}

}  // namespace

PreviewMaker::PreviewMaker(std::shared_ptr<Strand> strand, FrameSource& source, ClientSink& sink,
                           std::uint64_t view, Hooks hooks)
    : source_(source),
      sink_(sink),
      view_(view),
      hooks_(std::move(hooks)),
      tether_(std::move(strand)) {}

PreviewMaker::~PreviewMaker() { source_.release(view_); }

void PreviewMaker::want(const PreviewMessage& wish) {
  if (waiting_.size() >= kMostWaiting) {
    throw Error({.code = "rate-limited",
                 .message = "too many previews wait",
                 .expected = "at most " + std::to_string(kMostWaiting) + " at a time"});
  }
  waiting_.push_back(wish);
  make_next();
}

void PreviewMaker::make_next() {
  while (!busy_ && !waiting_.empty()) {
    const PreviewMessage wish = std::move(waiting_.front());
    waiting_.pop_front();
    try {
      begin(wish);
    } catch (const Error& error) {
      hooks_.failed(wish.request, error);
    }
  }
  if (!busy_) source_.release(view_);
}

void PreviewMaker::begin(const PreviewMessage& wish) {
  const SceneSnapshot shown = hooks_.scene(wish);
  busy_ = true;
  source_.submit(
      {.view = view_,
       .revision = shown.revision,
       .scene = shown.scene,
       .quality = preview_quality()},
      tether_.bind<FrameOutcome>([this, request = wish.request, shown](FrameOutcome outcome) {
        came_back(request, shown, std::move(outcome));
      }));
}

void PreviewMaker::came_back(std::uint32_t request, const SceneSnapshot& shown,
                             FrameOutcome outcome) {
  if (auto* frame = std::get_if<Frame>(&outcome)) {
    sink_.send_still(preview_message(request, shown.stamp, shown.scene->viewport, *frame),
                     tether_.bind<bool>([this](bool) { ended(); }));
    return;
  }
  const auto* error = std::get_if<Error>(&outcome);
  hooks_.failed(request, error != nullptr ? *error : given_up());
  ended();
}

void PreviewMaker::ended() {
  busy_ = false;
  make_next();
}

}  // namespace cutaway
