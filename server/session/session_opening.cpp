// A session's volume, from the wish to the first scene that shows it.
#include <utility>

#include "session/session.h"

namespace cutaway {

void Session::open_volume(const std::string& id, Json document, InputStamp stamp) {
  stop_opening();
  stamp_ = stamp;
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
  pay_for_lens_searches();
}

void Session::opening_failed(const Error& error, const Pending& pending) {
  refuse(error, {.input = pending.stamp.input, .request = {}});
  tell(loading_message(pending.volume, LoadEnd::failed));
}

void Session::show_opened(std::shared_ptr<const OpenVolume> volume, const Pending& pending) {
  const SceneState::Change change = state_.set_volume(std::move(volume), pending.document);
  tell(loading_message(pending.volume, LoadEnd::ready));
  // What came while it was opened is in it, too.
  took_effect({.scene = change.scene, .pictures = change.pictures, .chosen = false}, stamp_);
  if (change.scene) tell_scene();  // whether or not anything was chosen
}

}  // namespace cutaway
