// What each message of a client does to its session.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/scene_fields.h"
#include "scene/styles.h"
#include "session/pick.h"
#include "session/session.h"

namespace cutaway {

namespace {

Error no_volume() {
  return Error({.code = ErrorCode::no_volume,
                .message = "no scene is shown yet",
                .expected = "an open volume, and first a viewport of view 0 and of this one"});
}

/// Whoever waits for the 3-D picture of such a change is to hear that none will come.
bool awaits_picture(const Json& patch) { return !is_read_only_by(OnlyReader::slices, patch); }

std::optional<PickedPoint> picked_surface(const Scene& scene, const OpenVolume& volume,
                                          glm::dvec2 position_px) {
  const auto hit = pick(scene, volume, position_px);
  if (!hit) return std::nullopt;
  return PickedPoint{.position_mm = hit->position_mm,
                     .value = volume.value_at(hit->position_mm).value_or(hit->limit_value),
                     .units = volume.units(),
                     .branch = hit->branch};
}

std::optional<PickedPoint> picked_slice(const Scene& scene, const OpenVolume& volume,
                                        glm::dvec2 position_px) {
  const auto point = pick_on_slice(scene, volume, position_px);
  if (!point) return std::nullopt;
  return PickedPoint{.position_mm = point->position_mm,
                     .value = point->value,
                     .units = volume.units(),
                     .branch = {}};
}

}  // namespace

void Session::handle(const SceneMessage& message) {
  const auto wanted = volume_of(message.scene);
  const bool wants_shown = wanted && state_.volume() && *wanted == state_.volume()->facts().id;
  if (wanted && !wants_shown && wanted != opening_.volume()) {
    const Json base = state_.document_for_another_volume();
    return open_volume(*wanted, changed_document(base, message.scene, message.replace),
                       message.stamp);
  }
  if (wanted && !wants_shown) {
    pending_->document = changed_document(pending_->document, message.scene, message.replace);
    stamp_ = pending_->stamp = message.stamp;
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
  SceneState::Change change = state_.set_document(shown);
  const bool changes_nothing = !change.pictures[std::size_t(ViewKind::volume)];
  change.chosen = change.chosen || opens_a_field(message.scene) ||
                  (changes_nothing && awaits_picture(message.scene));
  took_effect(change, message.stamp);
  if (awaited) pending_->document = std::move(*awaited);
}

void Session::handle(const ViewportMessage& message) {
  check_pixels(message.width_px, message.height_px);
  SceneState::Change change =
      state_.set_viewport({message.width_px, message.height_px, message.view});
  const bool is_awaited = message.view == ViewKind::volume;
  change.chosen = change.chosen || (is_awaited && !change.pictures[std::size_t(message.view)]);
  took_effect(change, message.stamp);
}

void Session::handle(const CloseViewMessage& message) {
  state_.close(message.view);
  flow(message.view).hide();
}

void Session::handle(const DragLensMessage& message) {
  const Scene& scene = shown_scene();  // first: without one there is no volume either
  const glm::dvec3 centre = dragged_lens_centre(scene, *state_.volume(), message.position_px);
  const Json patch = {{"lens", {{"centre_mm", {centre.x, centre.y, centre.z}}}}};
  const Json document = changed_document(state_.document(), patch, false);
  took_effect(state_.set_document(document), message.stamp);
  tell_scene_soon();
}

void Session::handle(const PickMessage& message) {
  const Scene& scene = shown_scene(message.view);
  const OpenVolume& volume = *state_.volume();
  const auto point = message.view == ViewKind::volume
                         ? picked_surface(scene, volume, message.position_px)
                         : picked_slice(scene, volume, message.position_px);
  tell(picked_message(message.request, point));
}

void Session::handle(const CancelLoadMessage&) {
  const bool was_opening = pending_.has_value();
  stop_opening();
  if (was_opening) tell_scene_soon();  // no picture shows the input that wanted the volume
}

void Session::handle(const AckMessage& message) { flow(message.view).acknowledge(message.frame); }

void Session::handle(const SaveStillMessage& message) {
  stills_.require_room();  // before a lens' place is looked for
  const SceneSnapshot still = still_of(message);
  stills_.save(message.request, still, still_quality(settings_, still.scene->viewport));
}

void Session::handle(const PreviewMessage& message) {
  if (message.style) style(*message.style);  // refused now where there is none
  (message.volume ? volume_previews_ : previews_).want(message);
}

void Session::handle(const PresenceMessage& message) { page_visible_ = message.visible; }

const Scene& Session::shown_scene(ViewKind view) const {
  if (!state_.scene(view)) throw no_volume();
  return *state_.scene(view);
}

void Session::check_pixels(int width_px, int height_px) const {
  const std::int64_t pixels = std::int64_t{width_px} * height_px;
  if (pixels <= settings_.viewport_pixels) return;
  throw Error(
      {.code = ErrorCode::out_of_range,
       .message = "the picture has too many pixels",
       .field = "/width_px",
       .expected = fmt::format("width_px times height_px at most {}", settings_.viewport_pixels),
       .received = fmt::format("{} x {} = {}", width_px, height_px, pixels)});
}

}  // namespace cutaway
