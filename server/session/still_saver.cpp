#include "session/still_saver.h"

#include <utility>

namespace cutaway {

StillSaver::StillSaver(std::shared_ptr<Strand> strand, FrameSource& source, ClientSink& sink,
                       RenderView view, std::function<void(std::uint32_t, const Error&)> failed)
    : source_(source),
      sink_(sink),
      view_(std::move(view)),
      failed_(std::move(failed)),
      callbacks_(std::move(strand)) {}

StillSaver::~StillSaver() { source_.release(view_.view); }

void StillSaver::require_room() const {
  const std::size_t places = stage_ == Stage::writing ? 2 : 1;
  if (waiting_.size() < places) return;
  throw Error({.code = ErrorCode::rate_limited,
               .message = "a still is being made and another one waits",
               .expected = "the next save_still once one of the two came"});
}

void StillSaver::save(std::uint32_t request, SceneSnapshot snapshot, const FrameQuality& quality) {
  waiting_.push_back({request, std::move(snapshot), quality});
  if (stage_ == Stage::idle) make_next();
}

void StillSaver::make_next() {
  stage_ = waiting_.empty() ? Stage::idle : Stage::making;
  if (stage_ == Stage::idle) return;
  const Waiting next = std::move(waiting_.front());
  waiting_.pop_front();
  source_.submit_still({.view = view_.view,
                        .share = view_.share,
                        .session = view_.session,
                        .revision = next.shown.revision,
                        .scene = next.shown.scene,
                        .quality = next.quality},
                       callbacks_.bind<StillOutcome>([this, request = next.request,
                                                      shown = next.shown](StillOutcome outcome) {
                         came_back(request, shown, std::move(outcome));
                       }));
}

void StillSaver::came_back(std::uint32_t request, const SceneSnapshot& shown,
                           StillOutcome outcome) {
  source_.release(view_.view);
  if (const auto* still = std::get_if<SavedStill>(&outcome)) {
    stage_ = Stage::writing;
    sink_.send_still(saved_still_message(request, shown.stamp, shown.scene->viewport, *still),
                     callbacks_.bind<bool>([this](bool) { make_next(); }));
    return;
  }
  const auto* error = std::get_if<Error>(&outcome);
  failed_(request, error != nullptr ? *error : picture_given_up());
  make_next();
}

}  // namespace cutaway
