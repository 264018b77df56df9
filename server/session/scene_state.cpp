#include "session/scene_state.h"

#include <algorithm>
#include <utility>

#include "scene/first_look.h"
#include "scene/scene_fields.h"
#include "scene/slice_geometry.h"

namespace cutaway {

namespace {

// Does the complete document have a field that the other leaves open? Values that were only brought
// into another form (an up direction made square to the view) do not count.
bool says_more(const Json& complete, const Json& document) {
  if (complete.is_object()) {
    return std::ranges::any_of(complete.items(), [&document](const auto& field) {
      const auto said = document.find(field.key());
      return said == document.end() || says_more(field.value(), *said);
    });
  }
  if (!complete.is_array()) return false;
  for (std::size_t i = 0; i < complete.size(); ++i) {
    if (i >= document.size() || says_more(complete[i], document[i])) return true;
  }
  return false;
}

bool has_size(Viewport viewport) { return viewport.width_px > 0; }

// In a live session the document's viewport says nothing; the viewport message does.
Json without_viewport(Json document) {
  document.erase("viewport");
  return document;
}

}  // namespace

SceneState::Change SceneState::set_document(const Json& document) {
  return commit(document, viewports_, volume_);
}

SceneState::Change SceneState::set_viewport(Viewport viewport) {
  Viewports viewports = viewports_;
  viewports[static_cast<std::size_t>(viewport.kind)] = viewport;
  return commit(document_, viewports, volume_);
}

void SceneState::close(ViewKind view) {
  viewports_[static_cast<std::size_t>(view)] = {};
  scenes_[static_cast<std::size_t>(view)] = nullptr;
}

SceneState::Change SceneState::set_volume(std::shared_ptr<const OpenVolume> volume,
                                          const Json& document) {
  return commit(document, viewports_, std::move(volume));
}

SceneState::Change SceneState::commit(Json document, const Viewports& viewports,
                                      std::shared_ptr<const OpenVolume> volume) {
  Change change;
  const Viewport viewport = viewports[static_cast<std::size_t>(ViewKind::volume)];
  if (volume && !has_size(viewport)) {
    // Throws now what it would throw later.
    resolve_scene(with_first_look(document, volume->facts()), volume->facts(),
                  document_viewport(Json::object()), lenses_);
  } else if (volume) {
    const Scene resolved = resolve_scene(with_first_look(document, volume->facts()),
                                         volume->facts(), viewport, lenses_);
    Json complete = scene_document(resolved);
    const bool is_new_volume = volume != volume_;
    change.scene = is_new_volume || !scene() || resolved != *scene();
    change.chosen = says_more(without_viewport(complete), document);
    document = std::move(complete);
    put_scenes(resolved, viewports, is_new_volume, change);
  }
  document_ = std::move(document);
  viewports_ = viewports;
  volume_ = std::move(volume);
  if (change.scene) ++revision_;
  return change;
}

Json SceneState::document_for_another_volume() const {
  if (!volume_) return document_;
  Json document = without_volume_choices(document_);
  const bool is_untouched =
      scene() && has_first_look(document_, volume_->facts(), scene()->viewport);
  return is_untouched ? without_fields(std::move(document), BelongsTo::look) : document;
}

void SceneState::put_scenes(const Scene& scene, const Viewports& viewports, bool is_new_volume,
                            Change& change) {
  for (std::size_t view = 0; view < viewports.size(); ++view) {
    if (!has_size(viewports[view])) continue;
    Scene seen = scene;
    seen.viewport = viewports[view];
    const auto& before = scenes_[view];
    change.pictures[view] = is_new_volume || !before || !show_the_same(*before, seen);
    scenes_[view] = std::make_shared<const Scene>(std::move(seen));
  }
}

std::optional<std::string> volume_of(const Json& document) {
  const auto volume = document.find("volume");
  if (volume == document.end() || !volume->is_string()) return std::nullopt;
  return volume->get<std::string>();
}

Json changed_document(const Json& document, const Json& patch, bool replace) {
  Json changed = patch_scene_document(replace ? Json::object() : document, patch);
  if (!changed.contains("volume") && document.contains("volume")) {
    changed["volume"] = document["volume"];
  }
  return changed;
}

bool opens_a_field(const Json& patch) {
  if (patch.is_null()) return true;
  return patch.is_object() &&
         std::ranges::any_of(patch, [](const Json& field) { return opens_a_field(field); });
}

}  // namespace cutaway
